//! Scenes and their presentations as text, with other numbers.

use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Write;
use std::ops::Range;

pub struct Text {
    ron: String,
    pub numbers: Vec<Range<usize>>,
}

impl Text {
    pub fn of(value: &impl Serialize) -> Self {
        let ron = ron::to_string(value).expect("it has a text");
        let (mut numbers, mut at) = (Vec::new(), 0);
        for word in ron.split(['(', ')', '[', ']', ',', ':']) {
            if word.parse::<f32>().is_ok() {
                numbers.push(at..at + word.len());
            }
            at += word.len() + 1;
        }
        Self { ron, numbers }
    }

    pub fn field(&self, i: usize) -> (usize, &str) {
        let before = &self.ron[..self.numbers[i].start];
        let colon = before.rfind(':').expect("a number is in a field");
        let name = before[..colon].rsplit(['(', ',']).next();
        (colon + 1, name.expect("a name"))
    }

    pub fn with(&self, i: usize, number: f32) -> String {
        let Range { start, end } = self.numbers[i];
        format!("{}{number:?}{}", &self.ron[..start], &self.ron[end..])
    }

    /// Returns the value with other numbers, by their fields.
    pub fn map<T: DeserializeOwned>(&self, number: impl Fn(&str, f32) -> f32) -> T {
        let (mut ron, mut copied) = (String::new(), 0);
        for (i, Range { start, end }) in self.numbers.iter().cloned().enumerate() {
            let old = self.ron[start..end].parse().expect("it was parsed before");
            write!(ron, "{}{:?}", &self.ron[copied..start], number(self.field(i).1, old))
                .expect("memory");
            copied = end;
        }
        ron::from_str(&(ron + &self.ron[copied..])).expect("it has the same fields")
    }

    pub fn value_with<T: DeserializeOwned>(&self, i: usize, number: f32) -> (T, &str) {
        let value = ron::from_str(&self.with(i, number)).expect("it is a number");
        (value, self.field(i).1)
    }
}
