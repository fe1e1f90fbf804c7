#include "core/protocol/commands/drive_fields.h"

namespace usar::protocol {

/// A WheelNumber selects the wheel to which the segments after it apply.
void wheels(LineIn& in, std::vector<WheelDrive>& wheels) {
    for (const Segment& segment : in.segments().all()) {
        if (sameWord(segment.key, "WheelNumber")) {
            wheels.push_back({.wheel = in.wholeOf(segment)});
        } else if (sameWord(segment.key, "WheelSpeed") || sameWord(segment.key, "WheelSteer")) {
            if (wheels.empty())
                return in.refuse(segment.text, std::string(segment.key) + " of no wheel: WheelNumber comes first");
            if (sameWord(segment.key, "WheelSpeed"))
                wheels.back().spin_rad_s = in.numberOf(segment);
            else
                wheels.back().steer_rad = acrossWire(in.numberOf(segment));
        }
    }
}

void fields(LineIn& in, MultiDrive& drive) {
    for (const Segment& segment : in.segments().all()) {
        JointAngleTarget target{"?"};
        in.takeText("joint", segment.key, target.joint);
        target.angle_rad = in.numberOf(segment);
        drive.joints.push_back(std::move(target));
    }
}

} // namespace usar::protocol
