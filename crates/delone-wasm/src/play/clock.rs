//! How long a run takes, for races by time: the clock is read every few steps, and what lies between is
//! interpolated.
//!
//! The standard library knows no clock in a browser, so there the page's is asked. Some browsers blur it; readings
//! never go back. What recording costs is in the times, and much the same for every step.

/// Steps between two readings: a few µs, about as fine as browsers tell.
const STRIDE: usize = 64;

/// The milliseconds that a run had taken now and then.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Times {
    /// After each [`STRIDE`] steps, and after the last.
    readings: Vec<f32>,
    steps: usize,
}

/// Takes the times of a run that is going on.
pub(super) struct Stopwatch {
    clock: Clock,
    readings: Vec<f32>,
}

impl Stopwatch {
    /// Starts, before the first step.
    pub fn start() -> Self {
        Self {
            clock: Clock::start(),
            readings: vec![0.0],
        }
    }

    /// Told that so many steps have been taken.
    pub fn step(&mut self, steps: usize) {
        if steps.is_multiple_of(STRIDE) {
            self.read();
        }
    }

    /// Stops after the last of so many steps.
    pub fn stop(mut self, steps: usize) -> Times {
        if !steps.is_multiple_of(STRIDE) {
            self.read();
        }
        let readings = self.readings;
        Times { readings, steps }
    }

    fn read(&mut self) {
        let last = self.readings.last().copied().unwrap_or_default();
        self.readings.push(last.max(self.clock.milliseconds()));
    }
}

impl Times {
    /// Tells how many milliseconds the first `position` steps have taken.
    pub fn at(&self, position: usize) -> f64 {
        let position = position.min(self.steps);
        let last = position / STRIDE;
        let Some(&after) = self.readings.get(last + 1) else {
            return self.readings.last().copied().unwrap_or_default().into();
        };
        let stretch = STRIDE.min(self.steps - last * STRIDE);
        let share = (position % STRIDE) as f64 / stretch as f64;
        let before = f64::from(self.readings[last]);
        before + share * (f64::from(after) - before)
    }
}

/// A clock that has been started.
#[cfg(not(target_family = "wasm"))]
struct Clock(std::time::Instant);

#[cfg(not(target_family = "wasm"))]
impl Clock {
    fn start() -> Self {
        Self(std::time::Instant::now())
    }

    fn milliseconds(&self) -> f32 {
        self.0.elapsed().as_secs_f32() * 1000.0
    }
}

/// A clock that has been started: what the page's showed then.
#[cfg(target_family = "wasm")]
struct Clock(f64);

#[cfg(target_family = "wasm")]
impl Clock {
    fn start() -> Self {
        Self(now())
    }

    fn milliseconds(&self) -> f32 {
        (now() - self.0) as f32
    }
}

#[cfg(target_family = "wasm")]
#[wasm_bindgen::prelude::wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_between_readings_is_interpolated() {
        let times = Times {
            readings: vec![0.0, 64.0, 72.0],
            steps: STRIDE + 4,
        };
        let at = [0, 1, 63, 64, 65, 66, 68, 1000].map(|position| times.at(position));
        assert_eq!(at, [0.0, 1.0, 63.0, 64.0, 66.0, 68.0, 72.0, 72.0]);
        let nothing = Stopwatch::start().stop(0);
        assert_eq!(nothing.at(7), 0.0);
    }

    #[test]
    fn readings_never_go_back() {
        for steps in [1, STRIDE, 5 * STRIDE, 5 * STRIDE + 1] {
            let mut watch = Stopwatch::start();
            (1..=steps).for_each(|step| watch.step(step));
            let times = watch.stop(steps);
            assert_eq!(times.readings.len(), 1 + steps.div_ceil(STRIDE));
            assert!((0..steps).all(|i| times.at(i) <= times.at(i + 1)));
        }
    }
}
