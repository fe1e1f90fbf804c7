// The table that commandRules() returns, in the order in which users come across the commands.
#include <array>

#include "core/protocol/command_grammar.h"

namespace usar::protocol {

namespace {

using Words = std::string_view;
constexpr auto number = ValueForm::Number;
constexpr auto numbers = ValueForm::Numbers;
constexpr auto word = ValueForm::Word;

constexpr std::array<Words, 2> booleans = {"true", "false"};
constexpr std::array<Words, 14> classes = {
    "USARBot.P2DX",    "USARBot.P2AT",   "USARBot.P3AT",       "USARBot.AirRobot",       "USARBot.Kenaf",
    "USARBot.TeleMax", "USARBot.ATRVJr", "USARBot.Zerg",       "USARBot.Hummer",         "USARBot.Submarine",
    "USARBot.QRIO",    "USARBot.ERS",    "USARBot.ComStation", "USARBot.WorldController"};
constexpr std::array<Words, 26> asked_types = {
    "Robot",       "MisPkg",      "Actuator",    "Sonar",       "IR",       "RangeScanner", "IRScanner",
    "RangeImager", "GroundTruth", "INS",         "GPS",         "Odometry", "Encoder",      "Touch",
    "RFID",        "VictSensor",  "HumanMotion", "Sound",       "Camera",   "IMU",          "Tachometer",
    "Acoustic",    "Battery",     "Gripper",     "ToolChanger", "Effecter"};
constexpr std::array<Words, 13> set_types = {"INS",       "Odometry", "Encoder",    "RangeScanner", "RangeImager",
                                             "IRScanner", "Acoustic", "Camera",     "Viewports",    "Joint",
                                             "RFID",      "Gripper",  "ToolChanger"};
constexpr std::array<Words, 22> opcodes = {
    "POSE",          "RESET",       "SCAN",      "Zoom",   "FOV",       "Angle", "Velocity", "Torque",
    "RelAngle",      "RelVelocity", "RelTorque", "Target", "Stiffness", "Read",  "Write",    "Release",
    "TagsRemaining", "GRIP",        "OPEN",      "CLOSE",  "0",         "1"};
constexpr std::array<Words, 7> orders = {"0", "1", "2", "3", "10", "11", "12"};
constexpr std::array<Words, 3> package_orders = {"0", "1", "2"};
constexpr std::array<Words, 2> grips = {"0", "1"};
constexpr std::array<Words, 7> colors = {"Red", "Yellow", "Green", "Cyan", "White", "Blue", "Purple"};
constexpr std::array<Words, 2> view_layouts = {"SingleView", "QuadView"};
constexpr std::array<Words, 2> view_words = {"Disabled", "None"};
constexpr std::array<Words, 11> control_types = {"Create",   "Kill",  "KillAll", "AbsMove", "RelMove", "Rotate",
                                                 "Conveyor", "SetWP", "AddWP",   "ClearWP", "GetSTA"};
constexpr std::array<Words, 2> physics = {"None", "RigidBody"};
constexpr std::array<Words, 4> moves = {"New", "Append", "Pause", "Resume"};
constexpr std::array<Words, 3> gaits = {"Walk_Forward", "Walk_Backward", "Run"};

constexpr std::array init = {
    SegmentRule{"ClassName", "the robot's class, Package.Class", classes},
    SegmentRule{"Name", "the robot's name; without it the server invents one"},
    SegmentRule{"Location", "x,y,z in metres; z is down", {}, numbers},
    SegmentRule{"Rotation", "roll,pitch,yaw in radians; yaw is clockwise", {}, numbers},
    SegmentRule{"Start", "a start pose by name, instead of Location and Rotation (UDK)"},
    SegmentRule{"Battery", "seconds of battery (Gazebo)", {}, number},
};
constexpr std::array drive = {
    SegmentRule{"Left", "wheel spin of the left side, rad/s or per cent", {}, number},
    SegmentRule{"Right", "wheel spin of the right side, rad/s or per cent", {}, number},
    SegmentRule{"Speed", "wheel spin of a steered car, rad/s or per cent", {}, number},
    SegmentRule{"FrontSteer", "front steering angle, rad; to the right is positive", {}, number},
    SegmentRule{"RearSteer", "rear steering angle, rad", {}, number},
    SegmentRule{"WheelNumber", "the wheel that WheelSpeed and WheelSteer mean, from 0", {}, number, true},
    SegmentRule{"WheelSpeed", "spin of that wheel, rad/s", {}, number, true},
    SegmentRule{"WheelSteer", "steering angle of that wheel, rad", {}, number, true},
    SegmentRule{"AltitudeVelocity", "climb, m/s; up is positive", {}, number},
    SegmentRule{"LinearVelocity", "forward, m/s", {}, number},
    SegmentRule{"LateralVelocity", "sideways, m/s; right is positive", {}, number},
    SegmentRule{"RotationalVelocity", "turn, rad/s (UDK: degrees/s); clockwise is positive", {}, number},
    SegmentRule{"PitchAngle", "pitch in degrees (UDK)", {}, number},
    SegmentRule{"RollAngle", "roll in degrees (UDK)", {}, number},
    SegmentRule{"Propeller", "propeller speed, or per cent", {}, number},
    SegmentRule{"Rudder", "rudder angle, rad", {}, number},
    SegmentRule{"SternPlane", "stern plane angle, rad", {}, number},
    SegmentRule{"Name", "a joint, spelled exactly"},
    SegmentRule{"Order", "0 angle, 1 speed, 2 torque, 3 brake; 10, 11, 12 relative", orders, number},
    SegmentRule{"Value", "rad, m, rad/s or N m by Order", {}, number},
    SegmentRule{"Steer", "steering angle of the joint's wheel, rad", {}, number},
    SegmentRule{"Normalized", "true: values are per cent of the maximum, -100..100", booleans, word},
    SegmentRule{"Light", "head lights", booleans, word},
    SegmentRule{"Flip", "true rights the robot (UT2004)", booleans, word},
};
constexpr std::array multi_drive = {
    SegmentRule{"FRFlipper", "front right flipper, rad", {}, number},
    SegmentRule{"FLFlipper", "front left flipper, rad", {}, number},
    SegmentRule{"RRFlipper", "rear right flipper, rad", {}, number},
    SegmentRule{"RLFlipper", "rear left flipper, rad", {}, number},
    SegmentRule{"<joint>", "any joint by its name, rad", {}, number},
};
constexpr std::array question = {
    SegmentRule{"Type", "Robot, MisPkg, Actuator or a type of sensor", asked_types},
    SegmentRule{"Name", "one item; without it all of the type"},
};
constexpr std::array set = {
    SegmentRule{"Type", "the type of sensor or effecter", set_types},
    SegmentRule{"Name", "the item"},
    SegmentRule{"Opcode", "what to do", opcodes},
    SegmentRule{"Params", "INS: x,y,z,roll,pitch,yaw; Joint: value; Camera: radians; RFID: id and text"},
    SegmentRule{"Value", "a value that some clients add", {}, number},
    SegmentRule{"Robot", "the robot whose camera to show"},
    SegmentRule{"Client", "the viewer's address; alone it detaches the viewer"},
    SegmentRule{"Config", "how the screen is cut (UT2004)", view_layouts, word},
    SegmentRule{"Viewport1", "a camera, Disabled or None", view_words},
    SegmentRule{"Viewport2", "a camera, Disabled or None", view_words},
    SegmentRule{"Viewport3", "a camera, Disabled or None", view_words},
    SegmentRule{"Viewport4", "a camera, Disabled or None", view_words},
};
constexpr std::array package = {
    SegmentRule{"Name", "the mission package"},
    SegmentRule{"Link", "a link of it, from 1", {}, number, true},
    SegmentRule{"Value", "rad, m, rad/s or N m by Order", {}, number, true},
    SegmentRule{"Order", "0 angle, 1 speed, 2 torque", package_orders, number, true},
    SegmentRule{"Rotation", "0,tilt,pan in radians: the old way to turn a camera", {}, numbers},
    SegmentRule{"Seq", "a stored sequence (UDK)", {}, number},
    SegmentRule{"Gripper", "1 closes it, 0 opens it (UDK)", grips, number},
};
constexpr std::array act = {
    SegmentRule{"Name", "the actuator"},
    SegmentRule{"Link", "a link of it, from 1", {}, number, true},
    SegmentRule{"Value", "rad or m", {}, number, true},
    SegmentRule{"Gripper", "1 closes it, 0 opens it", grips, number},
    SegmentRule{"Sequence", "a stored sequence", {}, number},
};
constexpr std::array trace = {
    SegmentRule{"On", "whether to leave marks", booleans, word},
    SegmentRule{"Interval", "seconds between marks", {}, number},
    SegmentRule{"Color", "of the marks", colors, word},
};
constexpr std::array control = {
    SegmentRule{"Type", "what to do with the object", control_types, word, true},
    SegmentRule{"Name", "the object"},
    SegmentRule{"ClassName", "its class"},
    SegmentRule{"Location", "x,y,z in metres; z is down", {}, numbers},
    SegmentRule{"Rotation", "roll,pitch,yaw in radians; yaw is clockwise", {}, numbers},
    SegmentRule{"Start", "a start point by name"},
    SegmentRule{"Scale", "x,y,z", {}, numbers},
    SegmentRule{"Physics", "RigidBody falls and can be pushed", physics, word},
    SegmentRule{"Permanent", "stays when this connection ends", booleans, word},
    SegmentRule{"Memory", "free text kept with the object"},
    SegmentRule{"Material", "its material"},
    SegmentRule{"MinPos", "x,y,z: a corner of the box to clear", {}, numbers},
    SegmentRule{"MaxPos", "x,y,z: the opposite corner", {}, numbers},
    SegmentRule{"Speed", "m/s, or x,y,z in rad/s for Rotate", {}, numbers},
    SegmentRule{"Time", "seconds for the whole way", {}, number},
    SegmentRule{"Loop", "goes round for ever", booleans, word},
    SegmentRule{"ResetOnClear", "back to its place when the way is cleared", booleans, word},
    SegmentRule{"Moving", "starts at once", booleans, word},
    SegmentRule{"WP", "way points x,y,z;x,y,z in metres"},
};
constexpr std::array at_location = {SegmentRule{"Location", "x,y,z in metres; z is down", {}, numbers}};
constexpr std::array go_to = {SegmentRule{"Name", "the path node"}};
constexpr std::array move = {
    SegmentRule{"Action", "New and Append give a goal", moves, word},
    SegmentRule{"Type", "the gait", gaits, word},
    SegmentRule{"Location", "x,y in metres", {}, numbers},
    SegmentRule{"Pathnode", "a path node, instead of Location"},
};
constexpr std::array pause = {SegmentRule{"Time", "seconds", {}, number}};
constexpr std::array lockstep = {SegmentRule{"On", "whether the server waits for STEP", booleans, word}};
constexpr std::span<const SegmentRule> no_segments;

constexpr std::array rules = {
    CommandRule{"INIT", "spawns the robot of this connection",
                "INIT {ClassName USARBot.P2DX} {Name R1} {Location 4.5,1.9,1.8} {Rotation 0,0,0}", init},
    CommandRule{"GETSTARTPOSES", "asks where robots may start", "GETSTARTPOSES", no_segments},
    CommandRule{"DRIVE", "moves the robot or one joint until the next DRIVE", "DRIVE {Left 1} {Right 1}", drive},
    CommandRule{"MULTIDRIVE", "sets several joints at once (UT2004)", "MULTIDRIVE {FRFlipper 0.5} {FLFlipper 0.5}",
                multi_drive},
    CommandRule{"GETGEO", "asks for sizes and places", "GETGEO {Type Sonar}", question},
    CommandRule{"GETCONF", "asks for limits and settings", "GETCONF {Type Robot}", question},
    CommandRule{"SET", "sets a sensor, effecter, camera, view or joint",
                "SET {Type Odometry} {Name Odometry} {Opcode RESET}", set},
    CommandRule{"MISPKG", "moves a mission package, such as a camera's pan and tilt",
                "MISPKG {Name CameraPanTilt} {Link 1} {Value 0.5} {Link 2} {Value 0}", package},
    CommandRule{"ACT", "moves an actuator (UDK)", "ACT {Name KR60Arm} {Link 2} {Value 0.7854}", act},
    CommandRule{"TRACE", "leaves marks behind the robot (UT2004)", "TRACE {On true} {Interval 0.5} {Color Red}", trace},
    CommandRule{"CONTROL", "makes, moves and removes objects, on a world controller's connection",
                "CONTROL {Type Kill} {Name Box1}", control},
    CommandRule{"GETPATHNODES", "asks for the path nodes (UDK)", "GETPATHNODES", no_segments},
    CommandRule{"GETCLOSESTPATHNODE", "asks for the path node next to a place (UDK)",
                "GETCLOSESTPATHNODE {Location 3,4,0}", at_location},
    CommandRule{"GOTO", "sends an avatar to a path node (UDK)", "GOTO {Name PathNode_3}", go_to},
    CommandRule{"MOVE", "tells an avatar to walk (UDK)", "MOVE {Action New} {Type Run} {Location 3.5,-2}", move},
    CommandRule{"TEST", "does nothing", "TEST", no_segments},
    CommandRule{"PAUSE", "known from one client only", "PAUSE {Time 10}", pause},
    CommandRule{"LOCKSTEP", "our server only: time stands still until STEP", "LOCKSTEP {On true}", lockstep},
    CommandRule{"STEP", "our server only: the next tick may come", "STEP", no_segments},
};

} // namespace

std::span<const CommandRule> commandRules() {
    return rules;
}

} // namespace usar::protocol
