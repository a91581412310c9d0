//! `.gif`: an animation of pixels, for wherever SVG does not move.
//!
//! All frames share one palette, made of the colours of some of them. A frame holds only the rectangle
//! that has changed, and of it only the pixels that have: the others stay as they were.
//!
//! *Memory*: four frames of pixels, however many there are in all.

use super::frames::{FASTEST, Plan};
use super::palette::{Palette, TRANSPARENT};
use super::player::Player;
use super::raster;
use crate::Error;
use crate::target::Output;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use std::borrow::Cow;
use std::io::{self, Write};
use tiny_skia::Pixmap;

/// Frames whose colours make the palette.
const SAMPLES: usize = 16;

/// Units of time in a second.
const TICKS: f64 = 100.0;

/// Writes an animation; `start` makes a player that begins before the first step.
pub(super) fn write<'a>(
    out: &mut Output<'_>,
    start: impl Fn() -> Player<'a>,
    plan: &Plan,
) -> Result<(), Error> {
    let file = out.file().to_owned();
    let mut page = blank(&start());
    let palette = sample(start(), plan, &mut page)?;
    let sides = [page.width(), page.height()].map(|v| v as u16);
    let mut failed = None;
    let sink = Sink {
        out,
        failed: &mut failed,
    };
    let written = film(sink, start(), plan, &mut page, &palette, sides);
    match (written, failed) {
        (_, Some(error)) => Err(error),
        (Err(Broken::Player(error)), None) => Err(error),
        (Err(Broken::Encoder(reason)), None) => Err(Error::Picture { file, reason }),
        (Ok(()), None) => Ok(()),
    }
}

fn blank(player: &Player<'_>) -> Pixmap {
    let [width, height] = player.pen.view.page.map(|v| v as u32);
    Pixmap::new(width, height).expect("bug: the page has a size")
}

/// Makes a palette of the colours of some frames.
fn sample(mut player: Player<'_>, plan: &Plan, page: &mut Pixmap) -> Result<Palette, Error> {
    let stride = plan.ends.len().div_ceil(SAMPLES);
    let mut palette = Palette::default();
    // From the last one backwards, so that it is among them.
    let skipped = (plan.ends.len() - 1) % stride;
    for frame in plan.frames().skip(skipped).step_by(stride) {
        player.advance(frame)?;
        raster::draw(page, &player.marks, player.pen.detail);
        palette.learn(page.pixels());
    }
    palette.choose();
    Ok(palette)
}

/// Why a film breaks off.
enum Broken {
    Player(Error),
    Encoder(String),
}

impl From<gif::EncodingError> for Broken {
    fn from(error: gif::EncodingError) -> Self {
        Self::Encoder(error.to_string())
    }
}

fn film(
    sink: Sink<'_, '_>,
    mut player: Player<'_>,
    plan: &Plan,
    page: &mut Pixmap,
    palette: &Palette,
    [width, height]: [u16; 2],
) -> Result<(), Broken> {
    let mut encoder = Encoder::new(sink, width, height, &palette.bytes())?;
    encoder.set_repeat(Repeat::Infinite)?;
    let mut before: Vec<u8> = Vec::new();
    let mut now: Vec<u8> = Vec::new();
    let mut ticks = 0;
    for (i, frame) in plan.frames().enumerate() {
        player.advance(frame).map_err(Broken::Player)?;
        raster::draw(page, &player.marks, player.pen.detail);
        now.clear();
        now.extend(page.pixels().iter().map(|&pixel| palette.nearest(pixel)));
        let until = if frame.is_result {
            plan.total()
        } else {
            plan.begin(i + 1)
        };
        let delay = delay(until, ticks);
        ticks += u64::from(delay);
        let mut frame = changed(&before, &now, width);
        frame.delay = delay;
        encoder.write_frame(&frame)?;
        std::mem::swap(&mut before, &mut now);
    }
    Ok(())
}

/// Returns how long a frame lasts, so that the next begins in time.
fn delay(until: f64, ticks: u64) -> u16 {
    let least = TICKS / FASTEST;
    (until * TICKS - ticks as f64)
        .round()
        .clamp(least, u16::MAX.into()) as u16
}

/// Makes a frame of what differs from the one before.
fn changed(before: &[u8], now: &[u8], width: u16) -> Frame<'static> {
    let wide = usize::from(width);
    let differs = |i: usize| before.get(i) != Some(&now[i]);
    let rows = now.len() / wide;
    let in_row = |y: usize| (y * wide..(y + 1) * wide).any(differs);
    let top = (0..rows).find(|&y| in_row(y)).unwrap_or(0);
    let bottom = (top..rows).rfind(|&y| in_row(y)).unwrap_or(top);
    let in_column = |x: usize| (top..=bottom).any(|y| differs(y * wide + x));
    let left = (0..wide).find(|&x| in_column(x)).unwrap_or(0);
    let right = (left..wide).rfind(|&x| in_column(x)).unwrap_or(left);
    let mut buffer = Vec::with_capacity((bottom - top + 1) * (right - left + 1));
    for y in top..=bottom {
        let row = y * wide + left..=y * wide + right;
        buffer.extend(row.map(|i| if differs(i) { now[i] } else { TRANSPARENT }));
    }
    Frame {
        top: top as u16,
        left: left as u16,
        width: (right - left + 1) as u16,
        height: (bottom - top + 1) as u16,
        transparent: Some(TRANSPARENT),
        dispose: DisposalMethod::Keep,
        buffer: Cow::Owned(buffer),
        ..Frame::default()
    }
}

/// Passes bytes on, and keeps what went wrong.
struct Sink<'s, 'o> {
    out: &'s mut Output<'o>,
    failed: &'s mut Option<Error>,
}

impl Write for Sink<'_, '_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.out.many_bytes(bytes) {
            Ok(()) => Ok(bytes.len()),
            Err(error) => {
                *self.failed = Some(error);
                Err(io::ErrorKind::Other.into())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_what_has_changed() {
        let before = [0; 12];
        let mut now = before;
        now[5] = 3;
        now[10] = 4;
        let frame = changed(&before, &now, 4);
        assert_eq!(
            [frame.left, frame.top, frame.width, frame.height],
            [1, 1, 2, 2]
        );
        assert_eq!(frame.buffer[..], [3, TRANSPARENT, TRANSPARENT, 4]);
        let same = changed(&now, &now, 4);
        assert_eq!(same.buffer[..], [TRANSPARENT]);
        let first = changed(&[], &now, 4);
        assert_eq!((first.width, first.height), (4, 3));
        assert_eq!(first.buffer[..], now);
    }

    #[test]
    fn delays_do_not_drift() {
        let mut ticks = 0;
        for frame in 1..=100 {
            ticks += u64::from(delay(f64::from(frame) * 0.0333, ticks));
        }
        assert_eq!(ticks, 333);
        assert_eq!(delay(0.0, 7), 2);
        assert_eq!(delay(1e9, 0), u16::MAX);
    }
}
