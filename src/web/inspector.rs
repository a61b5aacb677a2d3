use eightfold_tracer::Counts;
use eightfold_tracer::observe::{Fill, Observer, Split};
use std::sync::{Mutex, PoisonError};

/// Records the squares that contain a pixel, and the points around the pixel.
pub struct Inspector {
    pixel: [usize; 2],
    squares: Mutex<Vec<String>>,
    points: Mutex<Vec<String>>,
}

impl Inspector {
    /// The maximum distance of recorded points in pixels.
    const NEAR: usize = 32;

    pub fn new(x: usize, y: usize) -> Self {
        Self { pixel: [x, y], squares: Mutex::default(), points: Mutex::default() }
    }

    /// Returns JSON: the squares, the largest first, each with its corner, sides and reason, and
    /// the traced points.
    pub fn json(self) -> String {
        let [squares, points] = [self.squares, self.points]
            .map(|list| list.into_inner().unwrap_or_else(PoisonError::into_inner));
        let (squares, points) = (squares.join(","), points.join(","));
        format!(r#"{{"squares":[{squares}],"points":[{points}]}}"#)
    }

    fn note(&self, [x, y]: [usize; 2], [w, h]: [usize; 2], what: &str) {
        let [px, py] = self.pixel;
        if (x..x + w).contains(&px) && (y..y + h).contains(&py) {
            let square = format!(r#"{{"x":{x},"y":{y},"w":{w},"h":{h},"what":"{what}"}}"#);
            push(&self.squares, square);
        }
    }
}

fn push(list: &Mutex<Vec<String>>, text: String) {
    let list = list.lock();
    list.unwrap_or_else(PoisonError::into_inner).push(text);
}

impl Observer for &Inspector {
    fn point(self, x: usize, y: usize, _: Counts) {
        let [px, py] = self.pixel;
        if x.abs_diff(px).max(y.abs_diff(py)) <= Inspector::NEAR {
            push(&self.points, format!("[{x},{y}]"));
        }
    }

    fn square(self, x: usize, y: usize, w: usize, h: usize, fill: Fill) {
        let what = match fill {
            Fill::Flat => "filled with one colour",
            Fill::Bilinear => "filled by interpolation between its corners",
            Fill::Patterned => "filled with interpolated light; each pixel has its own pattern",
            _ => "each pixel traced or averaged",
        };
        self.note([x, y], [w, h], what);
    }

    fn split(self, x: usize, y: usize, side: usize, why: Split) {
        let what = match why {
            Split::Uncovered => "split: an object or a shadow may be between its corners",
            Split::Keys => "split: its corners show different objects or light",
            Split::Colours => "split: its corners\u{2019} colours differ too much",
            _ => "split: it lies between two split squares",
        };
        self.note([x, y], [side; 2], what);
    }
}
