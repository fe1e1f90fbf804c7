// The JSON Schemas of the messages in an exported recording: Foxglove's own where there is one, else ours.
#pragma once

#include "core/mission/files/mcap_writer.h"

namespace usar::mission::schemas {

// Each has a `timestamp`, and the program's frames: right-handed, x forward, y left, z up; meters and radians. Their
// texts live as long as the program.

const McapSchema& poseInFrame();    ///< foxglove.PoseInFrame
const McapSchema& posesInFrame();   ///< foxglove.PosesInFrame
const McapSchema& frameTransform(); ///< foxglove.FrameTransform
const McapSchema& laserScan();      ///< foxglove.LaserScan
const McapSchema& rawImage();       ///< foxglove.RawImage
const McapSchema& grid();           ///< foxglove.Grid
const McapSchema& log();            ///< foxglove.Log

const McapSchema& range();   ///< usar.Range: one range along a sensor's x axis
const McapSchema& command(); ///< usar.Command: a command that was sent, and why
const McapSchema& status();  ///< usar.Status: what a behavior is doing
const McapSchema& plan();    ///< usar.Plan: which parts of a POSH plan are active

} // namespace usar::mission::schemas
