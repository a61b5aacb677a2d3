mod camera;
mod display;
mod ending;
mod keys;
mod reload;
