//! How alike two pictures are.
//!
//! Renderers differ in how they smooth edges and where they put a line that falls between pixels. What must
//! not differ is what one sees: where lines, letters and areas are, and their colours. So four things are
//! measured, and each must hold.
//!
//! 1. **Strays.** Both pictures are blurred (Gaussian, sigma 1 pixel), so that a thin line looks the same
//!    whether it falls onto one row of pixels or onto two. Each blurred pixel of either picture must then lie,
//!    in every colour component, in the range of the blurred pixels of the other picture in the 3 x 3
//!    neighbourhood, give or take [`STRAY`]. What lies outside is something that the other picture does not
//!    have within a pixel: a stray.
//! 2. **Flat colours.** Where a pixel and all its neighbours up to two pixels away have one colour in each of
//!    both pictures, the two colours must agree within [`COLOUR`].
//! 3. **Balance.** The sums of ink (the distance from white) must agree.
//! 4. **Shift.** The shift by which the blurred pictures fit best (least squares of the differences against the
//!    gradients) must be small: it tells a displacement of everything that is too small for strays.

/// A square picture; colour components from 0 to 255.
#[derive(Clone, PartialEq)]
pub(crate) struct Picture {
    pub(crate) side: usize,
    pub(crate) pixels: Vec<[u8; 3]>,
}

/// How far a blurred component may lie outside of the range of its counterparts, of 255. A line as wide as a
/// pixel is 97 deep when it is blurred.
const STRAY: f32 = 36.0;

/// How far the components of flat colours may be apart, of 255.
const COLOUR: i32 = 4;

/// How far pixels may be from one another to be a neighbourhood of one colour.
const FLAT: usize = 2;

/// What may be different.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Limits {
    /// Number of stray pixels.
    pub(crate) strays: usize,
    /// Number of pixels with another flat colour.
    pub(crate) colours: usize,
    /// Part of the ink of the first picture.
    pub(crate) ink: f64,
    /// Shift of the whole, in pixels.
    pub(crate) shift: f64,
}

/// What is different.
#[derive(Clone, Debug, Default)]
pub(crate) struct Difference {
    pub(crate) strays: Vec<usize>,
    pub(crate) colours: Vec<usize>,
    pub(crate) ink: f64,
    pub(crate) shift: f64,
}

impl Picture {
    /// The mean of every `factor` x `factor` pixels.
    pub(crate) fn reduced(&self, factor: usize) -> Picture {
        let side = self.side / factor;
        let mut sums = vec![[0u32; 3]; side * side];
        for (y, row) in self.pixels.chunks_exact(self.side).take(side * factor).enumerate() {
            let target = &mut sums[y / factor * side..][..side];
            for (sum, block) in target.iter_mut().zip(row.chunks_exact(factor)) {
                for pixel in block {
                    for (sum, &value) in sum.iter_mut().zip(pixel) {
                        *sum += u32::from(value);
                    }
                }
            }
        }
        let count = (factor * factor) as u32;
        let mean = |sum: [u32; 3]| sum.map(|v| ((v + count / 2) / count) as u8);
        Picture { side, pixels: sums.into_iter().map(mean).collect() }
    }

    fn blurred(&self) -> Vec<[f32; 3]> {
        // Gaussian with sigma 1.
        const WEIGHTS: [f32; 4] = [0.399_05, 0.242_04, 0.054_01, 0.004_43];
        let (side, last) = (self.side, self.side - 1);
        let at = |i: usize| self.pixels[i].map(f32::from);
        let mut across = vec![[0.0f32; 3]; side * side];
        let mut down = across.clone();
        let pass = |get: &dyn Fn(usize) -> [f32; 3], out: &mut [[f32; 3]], step: usize, line: usize| {
            for l in 0..side {
                for k in 0..side {
                    let index = |k: usize| l * line + k * step;
                    let mut sum = get(index(k)).map(|v| v * WEIGHTS[0]);
                    for (d, weight) in WEIGHTS.iter().enumerate().skip(1) {
                        let (a, b) = (get(index(k.saturating_sub(d))), get(index((k + d).min(last))));
                        for c in 0..3 {
                            sum[c] += weight * (a[c] + b[c]);
                        }
                    }
                    out[index(k)] = sum;
                }
            }
        };
        pass(&at, &mut across, 1, side);
        pass(&|i| across[i], &mut down, side, 1);
        down
    }

    /// The sum of ink.
    fn ink(&self) -> f64 {
        let ink = |pixel: &[u8; 3]| pixel.iter().map(|&v| 255 - u64::from(v)).sum::<u64>();
        self.pixels.iter().map(ink).sum::<u64>() as f64 / 765.0
    }

    /// Whether the pixel and its neighbours have one colour.
    fn is_flat(&self, index: usize) -> bool {
        let (x, y) = (index % self.side, index / self.side);
        let inside = FLAT..self.side - FLAT;
        let colour = self.pixels[index];
        inside.contains(&x)
            && inside.contains(&y)
            && (y - FLAT..=y + FLAT).all(|v| {
                let row = &self.pixels[v * self.side + x - FLAT..][..2 * FLAT + 1];
                row.iter().all(|&pixel| pixel == colour)
            })
    }
}

/// What is different between two pictures of the same size.
pub(crate) fn compare(a: &Picture, b: &Picture) -> Difference {
    assert_eq!(a.side, b.side);
    let colours = (0..a.pixels.len()).filter(|&i| {
        let apart = |c: usize| (i32::from(a.pixels[i][c]) - i32::from(b.pixels[i][c])).abs();
        (0..3).any(|c| apart(c) > COLOUR) && a.is_flat(i) && b.is_flat(i)
    });
    let (one, other) = (a.blurred(), b.blurred());
    let strays = (0..one.len()).filter(|&i| {
        (0..3).any(|c| {
            (one[i][c] - other[i][c]).abs() > STRAY
                && (outside(&one, &other, a.side, i, c) || outside(&other, &one, a.side, i, c))
        })
    });
    let strays: Vec<usize> = strays.collect();
    let (ink_a, ink_b) = (a.ink(), b.ink());
    let ink = if ink_a == ink_b { 0.0 } else { (ink_a - ink_b).abs() / ink_a.max(1.0) };
    Difference { strays, colours: colours.collect(), ink, shift: shift(&one, &other, a.side) }
}

/// The length of the shift by which two blurred pictures fit best: B. D. Lucas and T. Kanade, "An Iterative Image
/// Registration Technique with an Application to Stereo Vision", IJCAI 1981, one step over the whole picture.
fn shift(one: &[[f32; 3]], other: &[[f32; 3]], side: usize) -> f64 {
    let (mut xx, mut xy, mut yy, mut xd, mut yd) = (1e-9, 0.0, 1e-9, 0.0, 0.0);
    let mean = |i: usize, c: usize| f64::from(one[i][c] + other[i][c]);
    for y in 1..side - 1 {
        for x in 1..side - 1 {
            let i = y * side + x;
            for c in 0..3 {
                let (gx, gy) = (mean(i + 1, c) - mean(i - 1, c), mean(i + side, c) - mean(i - side, c));
                // Both gradients are sums over two pictures and two pixels.
                let d = 4.0 * f64::from(one[i][c] - other[i][c]);
                xx += gx * gx;
                xy += gx * gy;
                yy += gy * gy;
                xd += gx * d;
                yd += gy * d;
            }
        }
    }
    // Lines tell no shift along themselves.
    let doubt = (xx + yy) * 0.05;
    (xx, yy) = (xx + doubt, yy + doubt);
    let determinant = xx * yy - xy * xy;
    ((yy * xd - xy * yd) / determinant).hypot((xx * yd - xy * xd) / determinant)
}

/// Whether a component of pixel `i` lies outside of the range of the pixels around it in the other picture.
fn outside(one: &[[f32; 3]], other: &[[f32; 3]], side: usize, i: usize, component: usize) -> bool {
    let (x, y) = (i % side, i / side);
    let (mut low, mut high) = (f32::MAX, f32::MIN);
    for v in y.saturating_sub(1)..=(y + 1).min(side - 1) {
        for u in x.saturating_sub(1)..=(x + 1).min(side - 1) {
            let value = other[v * side + u][component];
            (low, high) = (low.min(value), high.max(value));
        }
    }
    let value = one[i][component];
    value < low - STRAY || value > high + STRAY
}

impl Difference {
    /// Why the difference exceeds the limits; none if it does not.
    pub(crate) fn fault(&self, limits: &Limits) -> Option<String> {
        let Difference { strays, colours, ink, shift } = self;
        let bad = strays.len() > limits.strays
            || colours.len() > limits.colours
            || *ink > limits.ink
            || *shift > limits.shift;
        bad.then(|| self.to_string())
    }

    /// The first picture, pale, with strays in red and other flat colours in blue.
    pub(crate) fn shown(&self, on: &Picture) -> Picture {
        let pale = |v: u8| 255 - (255 - v) / 4;
        let mut shown = Picture { side: on.side, pixels: on.pixels.iter().map(|p| p.map(pale)).collect() };
        for (pixels, colour) in [(&self.colours, [0, 0, 255]), (&self.strays, [255, 0, 0])] {
            for &i in pixels {
                shown.pixels[i] = colour;
            }
        }
        shown
    }
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Difference { strays, colours, ink, shift } = self;
        let (strays, colours, ink) = (strays.len(), colours.len(), ink * 100.0);
        write!(f, "strays {strays:5}  flat colours {colours:5}  ink {ink:5.1} %  shift {shift:5.2}")
    }
}
