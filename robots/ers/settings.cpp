#include "robots/ers/settings.h"

namespace usar::ers {

namespace {

using S = Settings;

constexpr agent::ParameterRow<Settings> rows[]{
    {&S::stride_m, "stride_m", "Stride", "Walking", "m", 0.01, 0.08, "Length of a step."},
    {&S::lift_m, "lift_m", "Lift", "Walking", "m", 0.005, 0.03, "How high a paw is lifted during a step."},
    {&S::tight_share_pct, "tight_share_pct", "Inner stride, tight", "Circles", "%", -100, 90,
     "Stride of the inner paws in a tight circle, as a share of that of the outer paws. Negative values are steps "
     "backward. Tight circles come first, because the ball may lie beside the robot."},
    {&S::wide_share_pct, "wide_share_pct", "Inner stride, wide", "Circles", "%", -100, 90,
     "The same for a wide circle, which takes the robot to another place."},
    {&S::circle_s, "circle_s", "Time for a circle", "Circles", "s", 2, 300,
     "Time after which the robot changes from tight to wide circles, or back."},
    {&S::play_time_s, "play_time_s", "Play for", "Walking", "s", 0, 86400,
     "The behavior ends after this time. With 0, it runs until you end it."},
    {&S::steering, "steering", "Steering", "Ball", "", 0.1, 10,
     "How much the strides on the ball's side shorten when the ball is off the middle of the picture."},
    {&S::near_rad, "near_rad", "Near when below", "Ball", "rad", radians(5), radians(60),
     "The ball is near when the head looks down by more than this."},
    {&S::kick_s, "kick_s", "Walk on", "Ball", "s", 0.5, 30,
     "Time for which the robot walks on after a near ball left its sight. This is the kick."},
    {&S::trace, "trace", "Mark the way", "Trace", "", 0, 0, "The robot leaves colored points along its path."},
    {&S::trace_interval_s, "trace_interval_s", "Time between marks", "Trace", "s", 0.2, 60, "Time between two points."},
};

} // namespace

constinit const agent::ParameterTable<Settings> Settings::parameters{rows};

} // namespace usar::ers
