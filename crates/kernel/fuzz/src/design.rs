//! Gears, flanks and neutral curves out of drawn numbers: double circular arcs, arc-line flanks and free chains; every
//! kind of wave generator.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use strainwave_kernel::{
    Engagement, Gear, GeometryError, NeutralCurve, NeutralCurveModel, Point, Profile, RingPiece, RingShape, Segment,
};

use super::draw::Draw;

/// What [`Profile::new`] takes.
#[derive(Clone, Debug)]
pub struct Tooth {
    pub gear: Gear,
    pub flank: Vec<Segment>,
    pub offset: f64,
    pub fillet_radius: f64,
}

impl Tooth {
    pub fn profile(&self) -> Result<Profile, GeometryError> {
        Profile::new(self.gear, &self.flank, self.offset, self.fillet_radius)
    }
}

pub fn tooth(draw: &mut Draw, module: f64, teeth: u32, internal: bool) -> Tooth {
    let addendum = draw.number(0.6, 1.0);
    let flank = match draw.below(4) {
        0 | 1 => arc_flank(draw, addendum, true),
        2 => arc_flank(draw, addendum, false),
        _ => free_flank(draw, addendum),
    };
    let gear = Gear {
        teeth,
        pitch_radius: draw_factor(draw) * 0.5 * module * f64::from(teeth),
        addendum: addendum * module,
        dedendum: (addendum + draw.number(0.15, 0.4)) * module,
        internal,
    };
    Tooth {
        gear,
        flank: flank.into_iter().map(|row| row.segment(module)).collect(),
        offset: if draw.coin() { draw.number(-0.03, 0.02) * module } else { 0.0 },
        fillet_radius: if draw.coin() { draw.number(0.05, 0.5) * module } else { 0.0 },
    }
}

/// 1, but for extremes.
fn draw_factor(draw: &mut Draw) -> f64 {
    draw.number(1.0, 1.0)
}

/// A piece in modules.
struct Row {
    start: Point,
    normal_angle: f64,
    curvature: f64,
    length: f64,
}

impl Row {
    fn segment(&self, module: f64) -> Segment {
        Segment::new(self.start * module, self.normal_angle, self.curvature / module, self.length * module)
    }
}

/// A convex tip arc, the line tangent to it and, where asked for, the concave arc tangent to that.
fn arc_flank(draw: &mut Draw, addendum: f64, with_concave_arc: bool) -> Vec<Row> {
    let flank_angle = draw.number(4.0, 20.0).to_radians();
    let radius = draw.number(0.7, 3.0);
    let line_angle = FRAC_PI_2 - flank_angle;
    let joint = Point::new(draw.number(0.58, 0.8), draw.number(-0.1, 0.3));
    let center = joint - Point::at_angle(line_angle) * radius;
    let tip_angle = ((addendum - center.y) / radius).min(1.0).acos();
    let tip = center + Point::at_angle(tip_angle) * radius;
    let line_length = if with_concave_arc { draw.number(0.1, 0.85) } else { 1.0 };
    let mut rows = vec![
        Row { start: tip, normal_angle: tip_angle, curvature: 1.0 / radius, length: (line_angle - tip_angle) * radius },
        Row { start: joint, normal_angle: line_angle, curvature: 0.0, length: line_length },
    ];
    if with_concave_arc {
        let start = joint + Point::at_angle(line_angle).clockwise() * line_length;
        let curvature = -1.0 / draw.number(1.0, 4.0);
        rows.push(Row { start, normal_angle: line_angle, curvature, length: 0.6 });
    }
    rows
}

/// One to eight arcs and lines from knot to knot down the flank, with a corner at every knot.
fn free_flank(draw: &mut Draw, addendum: f64) -> Vec<Row> {
    let count = 1 + draw.below(8);
    let (top, bottom) = (addendum + 0.05, -addendum - 0.2);
    let (narrow, wide) = (draw.number(0.3, 0.5), draw.number(0.85, 1.15));
    let knots: Vec<Point> = (0..=count)
        .map(|i| {
            let share = f64::from(i) / f64::from(count);
            let shake = if i == 0 || i == count { 0.0 } else { draw.number(-0.3, 0.3) / f64::from(count) };
            let x = narrow + (wide - narrow) * share + draw.number(-0.06, 0.06);
            Point::new(x, top + (bottom - top) * share + shake)
        })
        .collect();
    knots.windows(2).map(|pair| row_between(draw, pair[0], pair[1])).collect()
}

/// The arc of a drawn curvature from one point to another: it turns by twice asin(κ chord / 2).
fn row_between(draw: &mut Draw, start: Point, end: Point) -> Row {
    let curvature = match draw.below(4) {
        0 => 0.0,
        // Nearly straight.
        1 => draw.magnitude(1e-14, 1e-2) * if draw.coin() { 1.0 } else { -1.0 },
        _ => draw.number(-0.9, 0.9),
    };
    let chord = end - start;
    let half_turn = (0.5 * curvature * chord.norm()).clamp(-1.0, 1.0).asin();
    let length = if half_turn == 0.0 { chord.norm() } else { chord.norm() * half_turn / half_turn.sin() };
    Row { start, normal_angle: (-chord.y).atan2(chord.x) - half_turn, curvature, length }
}

pub fn model(draw: &mut Draw) -> NeutralCurveModel {
    match draw.below(3) {
        0 => NeutralCurveModel::FirstOrder,
        1 => NeutralCurveModel::Shifted,
        _ => NeutralCurveModel::Inextensible,
    }
}

pub fn shape(draw: &mut Draw) -> RingShape {
    match draw.below(6) {
        0 => RingShape::Harmonics(vec![0.0, 1.0]),
        1 => {
            let overtones: Vec<f64> = [0.1, 0.03].map(|most| draw.number(-most, most)).to_vec();
            let mut terms = vec![0.0, 1.0 - overtones.iter().sum::<f64>()];
            terms.extend(overtones);
            RingShape::Harmonics(terms)
        }
        2 => RingShape::Harmonics((0..draw.below(9)).map(|_| draw.number(-1.0, 1.0)).collect()),
        3 => RingShape::Pieces(rollers(draw.number(0.0, 38.0).to_radians())),
        4 => RingShape::Pieces(dual_disk(draw.number(5.0, 40.0).to_radians())),
        _ => RingShape::Pieces(free_pieces(draw)),
    }
}

/// w/w0 for rollers at ±β (S. Timoshenko, Strength of Materials II, "Circular rings"); two rollers are β = 0.
fn rollers(beta: f64) -> Vec<RingPiece> {
    let (sin, cos) = beta.sin_cos();
    let at_roller = sin + (FRAC_PI_2 - beta) * cos;
    let k = 1.0 / (at_roller - 4.0 / PI);
    let p = -4.0 * k / PI;
    vec![
        RingPiece { phi_end: beta, p, c: k * at_roller, c_phi: 0.0, s: 0.0, s_phi: k * sin },
        RingPiece {
            phi_end: FRAC_PI_2,
            p,
            c: FRAC_PI_2 * k * cos,
            c_phi: -k * cos,
            s: k * (cos + beta * sin),
            s_phi: 0.0,
        },
    ]
}

/// w/w0 for a rim that lies on a circular disk over |φ| ≤ β, free beyond, with mean 0.
fn dual_disk(beta: f64) -> Vec<RingPiece> {
    let (sin, cos) = beta.sin_cos();
    let free = PI * (PI - 2.0 * beta - (2.0 * beta).sin());
    let scale = free - 8.0 * cos - 8.0 * beta * sin + 4.0 * PI * sin;
    let p = 4.0 * (PI * sin - 2.0 * beta * sin - 2.0 * cos) / scale;
    let q = 2.0 * PI / scale;
    vec![
        RingPiece { phi_end: beta, p, c: free / scale, c_phi: 0.0, s: 0.0, s_phi: 0.0 },
        RingPiece {
            phi_end: FRAC_PI_2,
            p: -8.0 * (cos + beta * sin) / scale,
            c: FRAC_PI_2 * q,
            c_phi: -q,
            s: 2.0 * PI * (1.0 + sin * sin) / scale,
            s_phi: 0.0,
        },
    ]
}

/// Stretches that need not even join.
fn free_pieces(draw: &mut Draw) -> Vec<RingPiece> {
    let count = 1 + draw.below(4);
    (1..=count)
        .map(|i| RingPiece {
            phi_end: draw.number(FRAC_PI_2, FRAC_PI_2) * f64::from(i) / f64::from(count),
            p: draw.number(-0.1, 0.1),
            c: draw.number(-1.0, 1.0),
            c_phi: draw.number(-0.5, 0.5),
            s: draw.number(-1.0, 1.0),
            s_phi: draw.number(-0.5, 0.5),
        })
        .collect()
}

pub fn curve(draw: &mut Draw, radius: f64, w0: f64) -> Result<NeutralCurve, GeometryError> {
    if draw.below(5) == 0 {
        let share = if draw.coin() { draw.number(0.0, 0.05) } else { 0.0 };
        return NeutralCurve::ellipse(radius, w0, share * radius);
    }
    let model = model(draw);
    NeutralCurve::polar(radius, w0, model, &Arc::new(shape(draw).sampled()?))
}

/// A flexspline, a circular spline of the same module and a neutral curve that takes the teeth into mesh.
pub fn engagement(draw: &mut Draw) -> Result<Engagement, GeometryError> {
    let module = draw.magnitude(0.1, 5.0);
    let teeth = draw.whole(10, 400);
    let difference = [2, 2, 2, 4][usize::from(draw.below(4))];
    let flexspline = tooth(draw, module, teeth, false).profile()?;
    let circular_spline = tooth(draw, module, teeth + difference, true).profile()?;
    let radius = flexspline.gear.signed_root_radius() - 0.5 * module * draw.number(0.5, 2.5);
    let w0 = 0.5 * f64::from(difference) * module * draw.number(0.8, 1.08);
    Engagement::new(flexspline, circular_spline, curve(draw, radius, w0)?)
}
