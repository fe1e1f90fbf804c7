// The table of sensors. A new sensor takes a file in this folder and a row here; reading, writing, panels, plots,
// recording and modules follow from the row.
#pragma once

#include "core/protocol/schema.h"
#include "core/protocol/sensors/environment.h"
#include "core/protocol/sensors/gps.h"
#include "core/protocol/sensors/inertia.h"
#include "core/protocol/sensors/point_clouds.h"
#include "core/protocol/sensors/pose.h"
#include "core/protocol/sensors/range_images.h"
#include "core/protocol/sensors/range_scan.h"
#include "core/protocol/sensors/rfid.h"
#include "core/protocol/sensors/sonar.h"
#include "core/protocol/sensors/touch.h"
#include "core/protocol/sensors/victims.h"
#include "core/protocol/sensors/wheels.h"

namespace usar::protocol {

/// The types of all sensor messages, most frequent first, because the reader searches from the top.
using SensorTypes = TypeList<SonarReadings,        //
                             RangeScan,            //
                             InsReading,           //
                             OdometryReading,      //
                             EncoderReadings,      //
                             GroundTruthReading,   //
                             GpsReading,           //
                             RangeReadings,        //
                             TouchReadings,        //
                             VictimReading,        //
                             RfidReading,          //
                             TachometerReading,    //
                             ImuReading,           //
                             AccelerationReading,  //
                             AccelerometerReading, //
                             AltitudeReading,      //
                             CompassReading,       //
                             InuReading,           //
                             Scan3d,               //
                             RangeImage,           //
                             PointCloud,           //
                             LineLaserReading,     //
                             VictimTagReading,     //
                             HumanMotionReading,   //
                             PlayersReading,       //
                             SoundReading,         //
                             AcousticReading,      //
                             GasReading,           //
                             BallReading,          //
                             MissionTimeReading,   //
                             ObjectsReading>;

} // namespace usar::protocol
