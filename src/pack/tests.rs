use proptest::{collection::vec, prelude::*};

use crate::{LONGEST, System, checksum, costs, decode, encode, model::Model, pack_executable};

fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let call = any::<i32>().prop_map(|to| [&[0xe8][..], &to.to_le_bytes()].concat());
    let again = (any::<u8>(), 1..300_usize).prop_map(|(byte, count)| vec![byte; count]);
    let instructions = prop::sample::select(vec![
        vec![0x48, 0x8d, 0x05, 1, 2, 3, 4],
        vec![0x0f, 0x84, 1, 0, 0, 0],
        vec![0xc3],
    ]);
    let part = prop_oneof![vec(any::<u8>(), 0..100), call, again, instructions];
    vec(part, 0..20).prop_map(|parts| parts.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn bytes_round_trip(bytes in bytes()) {
        prop_assert_eq!(decode(&encode(&bytes), bytes.len()).ok(), Some(bytes));
    }

    #[test]
    fn truncated_code_is_refused(bytes in bytes(), length: prop::sample::Index) {
        let code = encode(&bytes);
        if !code.is_empty() {
            prop_assert!(decode(&code[..length.index(code.len())], bytes.len()).is_err());
        }
    }

    #[test]
    fn random_code_terminates(length in 0..2 * LONGEST, code in vec(any::<u8>(), 0..50)) {
        if let Ok(bytes) = decode(&code, length) {
            prop_assert_eq!(bytes.len(), length);
        }
    }

    #[test]
    fn non_executables_are_refused(bytes in bytes()) {
        prop_assert!(pack_executable(&bytes, &[], &System::Linux).is_err());
        let header = [b"\x7fELF\x02\x01\x01", &*bytes].concat();
        prop_assert!(pack_executable(&header, &[], &System::Linux).is_err());
    }
}

/// Empty, one byte, runs, and invalid code: endless prefixes, jumps beyond the end.
#[test]
fn adversarial_bytes_round_trip() {
    let all: Vec<u8> = (0..=u8::MAX).cycle().take(70_000).collect();
    let jumps = [0xe9, 0xff, 0xff, 0xff, 0x7f].repeat(3000);
    let runs = [0, 1, 0x0f, 0x62, 0x66, 0x90, 0xc4, 0xff].map(|byte| vec![byte; 5000]);
    let mean = [vec![], vec![0xe8], vec![0x80], all, jumps];
    for bytes in mean.into_iter().chain(runs) {
        assert!(decode(&encode(&bytes), bytes.len()).ok() == Some(bytes));
    }
}

#[test]
fn costs_sum_to_packed_size() {
    let bytes: Vec<u8> = (0..10_000_u32).map(|i| ((i * i) >> 8) as u8).collect();
    let size = encode(&bytes).len() as f64;
    let bits: f64 = costs(&bytes).into_iter().map(f64::from).sum();
    // Plus 4 or 5 bytes that end the code.
    let expected = bits / 8.0 + 4.5;
    assert!((size - expected).abs() < 1.0, "{size} and {expected}");
}

/// The model, the file, the alignment to huge pages and the program's 33 MB add up to the 105 MB in
/// the stub's message.
#[test]
fn model_size_is_bounded() {
    assert!(size_of::<Model>() <= 66 << 20, "{}", size_of::<Model>());
}

/// Finds differences between machines and compilers. A changed model needs new values.
#[test]
fn packing_is_reproducible() {
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8 & 0x4f
    };
    let bytes: Vec<u8> = (0..50_000).map(|_| noise()).collect();
    let code = encode(&bytes);
    assert_eq!((code.len(), checksum(&code)), (31_903, 3_612_197_095));
}
