use eightfold::show;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_stage::{allocations::Counting, on_displays};
use eightfold_tracer::Quality;
use eightfold_window::cpu;
use eightfold_window::render_target::{InnerSize, Next, RenderTarget};
use eightfold_window::window::Window;

#[global_allocator]
static ALLOCATOR: Counting = Counting::new();

#[test]
fn frames_and_window_allocate_nothing() {
    on_displays(&[&[]], || {
        let mut window =
            Window::open(c"Eightfold", InnerSize::Exactly(320, 240)).expect("there is a display");
        let mut renderer = ThreadedRenderer::new(3);
        let mut frames = |range: std::ops::Range<u32>| {
            for frame in range {
                let (width, height) = window.size();
                let scene = show::model_scene(frame as f32 / 60.0);
                let (level, pixels) = (cpu::best().level, window.canvas(width, height));
                renderer.draw(level, &scene, &Quality::THESIS, width, pixels);
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
