#include "robots/ers/settings.h"

namespace usar::ers {

namespace {

using S = Settings;

constexpr agent::ParameterRow<Settings> rows[]{
    {&S::stride_m, "stride_m", "Stride", "Walking", "m", 0.01, 0.08, "How far a paw steps forward."},
    {&S::lift_m, "lift_m", "Lift", "Walking", "m", 0.005, 0.03, "How high a paw is lifted on its way."},
    {&S::tight_share_pct, "tight_share_pct", "Inner stride, tight", "Circles", "%", -100, 90,
     "Stride of the inner paws in a tight circle, of the outer ones'; negative: they step back. It is walked "
     "first: "
     "the ball may lie beside the robot."},
    {&S::wide_share_pct, "wide_share_pct", "Inner stride, wide", "Circles", "%", -100, 90,
     "The same in a wide circle, which takes the robot elsewhere."},
    {&S::circle_s, "circle_s", "A circle takes", "Circles", "s", 2, 300,
     "Time after which a tight circle becomes a wide one, and the other way round."},
    {&S::play_time_s, "play_time_s", "Play for", "Walking", "s", 0, 86400,
     "The behavior ends after this time; 0: a person ends it."},
    {&S::steering, "steering", "Steering", "Ball", "", 0.1, 10,
     "How much shorter the strides on the ball's side become, for how far it is off the middle of the picture."},
    {&S::near_rad, "near_rad", "Near when below", "Ball", "rad", radians(5), radians(60),
     "The ball is near when the head has to look down so far."},
    {&S::kick_s, "kick_s", "Walk on", "Ball", "s", 0.5, 30,
     "How long the robot walks on after a near ball has left its sight: that kicks it."},
    {&S::trace, "trace", "Mark the way", "Trace", "", 0, 0, "The robot leaves colored points behind."},
    {&S::trace_interval_s, "trace_interval_s", "A mark each", "Trace", "s", 0.2, 60, "Time between two points."},
};

} // namespace

constinit const agent::ParameterTable<Settings> Settings::parameters{rows};

} // namespace usar::ers
