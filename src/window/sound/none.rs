use core::convert::Infallible;

pub struct Device(Infallible);

impl Device {
    pub fn open(_: u32, _: u32) -> Result<Device, &'static str> {
        Err("sound is not supported on this system")
    }

    pub fn write(&mut self, _: &[[f32; 2]]) -> bool {
        match self.0 {}
    }

    pub fn delay(&mut self) -> Option<i64> {
        match self.0 {}
    }
}
