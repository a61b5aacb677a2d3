use crate::bitmap::register_fonts;
use anyhow::Result;
use plotters::coord::combinators::{BindKeyPoints, IntoLogRange};
use plotters::prelude::*;

const SIZE: (u32, u32) = (960, 600);
/// Distinguishable in colour blindness, too (Okabe and Ito).
const COLOURS: [RGBColor; 4] =
    [RGBColor(150, 150, 150), RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115)];

/// The horizontal axis is logarithmic.
pub struct Chart {
    pub x: &'static str,
    pub y: &'static str,
    pub legend: SeriesLabelPosition,
    pub series: Vec<Series>,
}

pub struct Series {
    pub name: String,
    pub points: Vec<(f64, f64)>,
    pub labels: Vec<String>,
    pub has_line: bool,
}

impl Chart {
    pub fn svg(&self, title: &str) -> Result<String> {
        register_fonts();
        let mut svg = String::new();
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let points = || self.series.iter().flat_map(|series| &series.points);
        let [x, y] = [range(points().map(|at| at.0)), range(points().map(|at| at.1))];
        let powers = (-3..9).map(|power| 10_f64.powi(power));
        let ticks = powers.flat_map(|power| [power, 2.0 * power, 5.0 * power]);
        let room = 0.05 * (y.1 - y.0).max(1.0);
        let mut chart = ChartBuilder::on(&area)
            .caption(title, ("sans-serif", 15))
            .margin(16)
            .x_label_area_size(46)
            .y_label_area_size(60)
            .build_cartesian_2d(
                (x.0 / 1.1..x.1 * 1.2).log_scale().with_key_points(ticks.collect()),
                y.0 - room..y.1 + room,
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .label_style(("sans-serif", 14))
            .x_desc(self.x)
            .y_desc(self.y)
            .x_label_formatter(&|x| ((x * 1e3).round() / 1e3).to_string())
            .draw()?;
        for (i, series) in self.series.iter().enumerate() {
            let colour = COLOURS[i % COLOURS.len()];
            let points = series.points.iter().copied();
            if series.has_line {
                chart.draw_series(LineSeries::new(points.clone(), colour))?;
            }
            chart
                .draw_series(points.clone().map(|at| Circle::new(at, 3, colour.filled())))?
                .label(&series.name)
                .legend(move |at| Circle::new(at, 4, colour.filled()));
            let labels = series.labels.iter().cloned().zip(points);
            let text =
                |(text, at)| EmptyElement::at(at) + Text::new(text, (5, -14), ("sans-serif", 12));
            chart.draw_series(labels.map(text))?;
        }
        let mut legend = chart.configure_series_labels();
        legend.background_style(WHITE).border_style(BLACK);
        legend.position(self.legend.clone());
        legend.label_font(("sans-serif", 14)).draw()?;
        area.present()?;
        drop(chart);
        drop(area);
        Ok(svg)
    }
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let all = values.fold((f64::INFINITY, 0.0), |all: (f64, f64), x| (all.0.min(x), all.1.max(x)));
    if all.0 > all.1 { (1.0, 2.0) } else { all }
}
