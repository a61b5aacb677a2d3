mod display;
mod keys;
mod session;
