//! Deflated streams (RFC 1950) that are passed on while they are written.

use gks_pipeline::device::DeviceError;
use miniz_oxide::DataFormat;
use miniz_oxide::deflate::core::{CompressorOxide, TDEFLFlush, TDEFLStatus, compress};

/// How many deflated bytes are passed on at a time.
const PORTION: usize = 1 << 16;

/// How hard to compress, from 1 to 9. Level 3 makes page descriptions 3 % shorter and takes twice the time, level 6
/// 8 % and eight times.
const LEVEL: u8 = 2;

/// Deflates one stream after the other.
pub(crate) struct Deflate {
    state: Box<CompressorOxide>,
    portion: Vec<u8>,
}

impl Deflate {
    /// Ready for the first stream.
    pub(crate) fn new() -> Self {
        let mut state = Box::<CompressorOxide>::default();
        state.set_format_and_level(DataFormat::Zlib, LEVEL);
        Deflate { state, portion: vec![0; PORTION] }
    }

    /// Adds bytes to the stream and gives `pass` what is deflated by then.
    pub(crate) fn write(
        &mut self,
        bytes: &[u8],
        pass: impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        self.run(bytes, TDEFLFlush::None, pass)
    }

    /// Completes the stream, gives `pass` the rest of it, and is ready for the next one.
    pub(crate) fn finish(
        &mut self,
        pass: impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        let done = self.run(&[], TDEFLFlush::Finish, pass);
        self.state.reset();
        done
    }

    fn run(
        &mut self,
        mut bytes: &[u8],
        flush: TDEFLFlush,
        mut pass: impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        loop {
            let (status, read, written) = compress(&mut self.state, bytes, &mut self.portion, flush);
            bytes = &bytes[read..];
            if written > 0 {
                pass(&self.portion[..written])?;
            }
            match status {
                TDEFLStatus::Done => return Ok(()),
                TDEFLStatus::Okay if bytes.is_empty() && flush == TDEFLFlush::None => return Ok(()),
                TDEFLStatus::Okay => {}
                _ => return Err(DeviceError::Encode("deflating failed".into())),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_of_any_length_come_back_and_flow() {
        let mut deflate = Deflate::new();
        for length in [0, 1, 1000, 3_000_000] {
            let mut state = 1_u32;
            let noise = std::iter::repeat_with(|| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 27) as u8
            });
            let text: Vec<u8> = noise.take(length).collect();
            let mut packed = Vec::new();
            for part in text.chunks(70_000) {
                deflate
                    .write(part, |bytes| {
                        packed.extend_from_slice(bytes);
                        Ok(())
                    })
                    .unwrap();
            }
            assert!(length < 1_000_000 || packed.len() > 100_000, "nothing was passed on before the end");
            deflate
                .finish(|bytes| {
                    packed.extend_from_slice(bytes);
                    Ok(())
                })
                .unwrap();
            assert_eq!(miniz_oxide::inflate::decompress_to_vec_zlib(&packed).unwrap(), text);
        }
    }

    #[test]
    fn failure_is_passed_back() {
        let mut deflate = Deflate::new();
        let fail = |_: &[u8]| Err(DeviceError::Encode("full".into()));
        deflate.write(b"text", fail).unwrap();
        assert!(deflate.finish(fail).is_err());
    }
}
