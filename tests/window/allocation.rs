use eightfold::show;
use eightfold_stage::{allocations::Counting, on_displays};
use eightfold_tracer::{Band, Frame, Job, Memory, Quality, Renderer, Threads, Worker};
use eightfold_window::{
    cpu,
    pool::Pool,
    render_target::{Next, RenderTarget},
    static_cell::StaticCell,
    window::Window,
};

#[global_allocator]
static ALLOCATOR: Counting = Counting::new();

const THREADS: usize = 3;

static MEMORY: StaticCell<Memory> = StaticCell::new(Memory::new());
static WORKERS: StaticCell<[Worker; THREADS]> = StaticCell::new([const { Worker::new() }; THREADS]);

struct PoolThreads(Pool, &'static mut [Worker; THREADS]);

impl Threads for PoolThreads {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        self.0.run(self.1, bands, job);
    }
}

#[test]
fn frames_and_window_allocate_nothing() {
    on_displays(&[&[]], || {
        let mut window = Window::open(c"Eightfold", 320, 240).expect("there is a display");
        let mut renderer = Renderer::with_memory(cpu::best().level, MEMORY.take());
        let mut threads = PoolThreads(Pool::new(THREADS), WORKERS.take());
        let mut frames = |range: std::ops::Range<u32>| {
            for frame in range {
                let (width, height) = window.size();
                let scene = show::model_scene(frame as f32 / 60.0);
                let frame = Frame::new(width, height, window.canvas(width, height));
                renderer
                    .render(&scene, &Quality::THESIS, frame, &mut threads)
                    .expect("all is valid");
                assert_eq!(window.show(), Next::GoOn);
            }
        };
        // The server sends the window's size during the first frames.
        frames(0..10);
        let before = ALLOCATOR.count();
        assert!(before > 0, "the count counts");
        frames(10..310);
        assert_eq!(ALLOCATOR.count() - before, 0, "allocations in 300 frames");
    });
}
