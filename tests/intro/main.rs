mod arguments;
mod headless;
mod size;
mod still;
mod terminal;
