use crate::error::Difference;

const DARK: [u32; 400] = [0; 400];

fn bright(light: u32) -> Vec<u32> {
    let mut pixels = DARK.to_vec();
    pixels[..64].fill(light);
    pixels
}

#[test]
fn pooled_psnr_uses_the_mean_squared_error() {
    let lights = [0x0002_0900, 0x0000_0011, 0];
    let differences = lights.map(|light| Difference::between(&DARK, &bright(light)));
    let squares = f64::from(64 * (2 * 2 + 9 * 9 + 17 * 17)) / (3 * 3 * DARK.len()) as f64;
    let psnr = 10.0 * (255.0 * 255.0 / squares).log10();
    assert!((Difference::pooled_psnr(&differences) - psnr).abs() < 1e-9);
    assert_eq!(differences.map(|it| it.over_8), [64, 64, 0]);
    assert!(differences[2].psnr.is_infinite());
    assert!(Difference::pooled_psnr(&differences[2..]).is_infinite());
}
