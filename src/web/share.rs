use eightfold_tracer::{Band, Counts, Job, Threads, Worker, presentation::Presentation};
use std::ops::Range;

/// Returns the rows in which a worker's bands begin. Kaleidoscopes of four or more sectors copy
/// pixels between rows: the first worker draws them.
pub fn rows_of(presentation: &Presentation, rows: Range<usize>, height: usize) -> Range<usize> {
    match (presentation.sectors >= 4.0, rows.start) {
        (false, _) => rows,
        (true, 0) if !rows.is_empty() => 0..height,
        (true, _) => 0..0,
    }
}

/// Draws a worker's bands in one of a frame's passes: drawing, antialiasing (if enabled), and
/// captions (if any). Antialiasing needs a row of each neighbour.
pub struct Share<'a> {
    pub worker: &'a mut Worker,
    pub rows: Range<usize>,
    pub pass: usize,
    /// The previous passes' work of all workers, for the captions.
    pub before: Counts,
    pub passes: usize,
    /// The first row of its bands, and the first row after them; reversed if it has none.
    pub drawn: [usize; 2],
    pub counts: Counts,
}

impl<'a> Share<'a> {
    pub fn new(worker: &'a mut Worker, rows: Range<usize>, pass: usize, before: Counts) -> Self {
        Self { worker, rows, pass, before, passes: 0, drawn: [usize::MAX, 0], counts: Counts::NONE }
    }
}

impl Threads for Share<'_> {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        let is_drawn = self.passes == self.pass;
        for band in bands.iter_mut() {
            let rows = band.rows_of_picture();
            if !self.rows.contains(&rows.start) {
                band.mark_external();
                continue;
            }
            let [first, end] = self.drawn;
            self.drawn = [first.min(rows.start), end.max(rows.end)];
            if is_drawn {
                job(self.worker, band);
                self.counts += band.counts;
            }
        }
        if let Some(band) = bands.first_mut().filter(|_| self.passes == 0) {
            band.counts += self.before;
        }
        self.passes += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eightfold::show;
    use eightfold_tracer::presentation::Moment;
    use eightfold_tracer::{Frame, Level, Memory, Preset, Quality, Renderer};

    const WIDTH: usize = 161;
    const HEIGHT: usize = 120;

    struct Part {
        renderer: Renderer<Box<Memory>>,
        worker: Box<Worker>,
        pixels: Vec<u32>,
    }

    impl Part {
        fn new() -> Self {
            let memory = Box::<Memory>::default();
            Self {
                renderer: Renderer::with_memory(Level::baseline(), memory),
                worker: Box::default(),
                pixels: vec![0; WIDTH * HEIGHT],
            }
        }

        /// Returns the number of passes, the rows of its bands, and its points.
        fn draw(
            &mut self,
            moment: &Moment,
            quality: &Quality,
            rows: Range<usize>,
            pass: usize,
            before: Counts,
        ) -> (usize, Range<usize>, u64) {
            let Moment { scene, presentation } = moment;
            let rows = rows_of(presentation, rows, HEIGHT);
            let mut share = Share::new(&mut self.worker, rows, pass, before);
            let frame = Frame::new(WIDTH, HEIGHT, &mut self.pixels);
            let frame = frame.with_presentation(presentation);
            self.renderer.render_valid(scene, quality, frame, &mut share);
            let [first, end] = share.drawn;
            (share.passes, first..end, share.counts.points)
        }
    }

    fn in_parts(scene: &Moment, quality: &Quality, cuts: &[usize]) -> Vec<u32> {
        let mut parts: Vec<Part> = cuts[1..].iter().map(|_| Part::new()).collect();
        let (mut pass, mut passes, mut before) = (0, 1, Counts::NONE);
        let mut drawn = Vec::new();
        while pass < passes {
            let mut points = 0;
            drawn.clear();
            for (part, cut) in parts.iter_mut().zip(cuts.windows(2)) {
                let done = part.draw(scene, quality, cut[0]..cut[1], pass, before);
                passes = done.0;
                drawn.push(done.1);
                points += done.2;
            }
            before.points += points;
            pass += 1;
            let row = |y: usize| y * WIDTH..(y + 1) * WIDTH;
            for below in 1..parts.len() {
                let (start, above) = (drawn[below].start, below - 1);
                let rows = [
                    parts[above].pixels[row(start - 1)].to_vec(),
                    parts[below].pixels[row(start)].to_vec(),
                ];
                parts[below].pixels[row(start - 1)].copy_from_slice(&rows[0]);
                parts[above].pixels[row(start)].copy_from_slice(&rows[1]);
            }
        }
        let rows = parts.iter().zip(drawn);
        rows.flat_map(|(part, rows)| part.pixels[rows.start * WIDTH..rows.end * WIDTH].to_vec())
            .collect()
    }

    #[test]
    fn first_worker_draws_kaleidoscopes() {
        let mut scene = Box::<Moment>::default();
        show::at(100.0, &mut scene);
        let rows = [0..64, 64..HEIGHT].map(|rows| rows_of(&scene.presentation, rows, HEIGHT));
        assert_eq!(rows, [0..HEIGHT, 0..0]);
        let [mut first, mut second, mut whole] = [Part::new(), Part::new(), Part::new()];
        // Without antialiasing a frame has one pass.
        let quality = Preset::Fastest.quality();
        first.draw(&scene, quality, 0..64, 0, Counts::NONE);
        let (_, _, points) = second.draw(&scene, quality, 64..HEIGHT, 0, Counts::NONE);
        assert_eq!(points, 0);
        let frame = Frame::new(WIDTH, HEIGHT, &mut whole.pixels);
        let frame = frame.with_presentation(&scene.presentation);
        whole.renderer.render_valid(&scene.scene, quality, frame, &mut *whole.worker);
        assert!(first.pixels == whole.pixels);
    }

    #[test]
    fn frame_in_parts_has_same_bits() {
        let mut scene = Box::<Moment>::default();
        // With edges, with a caption that shows the points, with squares of 32.
        for time in [62.3, 37.5, 24.05] {
            show::at(time, &mut scene);
            for quality in [Quality::DEFAULT, *Preset::Fastest.quality(), Quality::EXHAUSTIVE] {
                let mut part = Part::new();
                let frame = Frame::new(WIDTH, HEIGHT, &mut part.pixels);
                let frame = frame.with_presentation(&scene.presentation);
                part.renderer.render_valid(&scene.scene, &quality, frame, &mut *part.worker);
                for cuts in [&[0, HEIGHT][..], &[0, 64, HEIGHT], &[0, 32, 64, 96, HEIGHT]] {
                    let parts = in_parts(&scene, &quality, cuts);
                    assert!(parts == part.pixels, "{time} s, {cuts:?}");
                }
            }
        }
    }
}
