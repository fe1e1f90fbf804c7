#include "core/protocol/commands/robot_fields.h"

#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

namespace {

/// A Link selects the link to which the Value (and Order) after it apply.
template <class Target>
void readLinks(LineIn& in, std::vector<Target>& links) {
    for (const Segment& segment : in.segments().all()) {
        const bool value = sameWord(segment.key, "Value");
        const bool order = sameWord(segment.key, "Order");
        if ((value || order) && links.empty())
            return in.refuse(segment.text, std::string(segment.key) + " of no link: Link comes first");
        if (sameWord(segment.key, "Link"))
            links.push_back({.link = in.wholeOf(segment)});
        else if (value)
            links.back().value = in.numberOf(segment);
        else if constexpr (requires(Target target) { target.order; }) {
            if (order)
                links.back().order = in.meaningOf<LinkOrder>(segment);
        }
    }
}

} // namespace

void links(LineIn& in, std::vector<LinkTarget>& links) {
    readLinks(in, links);
}

void links(LineIn& in, std::vector<LinkValue>& links) {
    readLinks(in, links);
}

void fields(LineIn& in, PackageRotation& rotation) {
    in.text("Name", rotation.package);
    Vec3 angles_rad = Vec3::Zero();
    in.vector("Rotation", angles_rad);
    rotation.tilt_rad = angles_rad.y();
    rotation.pan_rad = angles_rad.z();
    in.choice("Order", rotation.order);
}

void fields(LineIn& in, Lockstep& lockstep) {
    const std::optional<bool> on = readBoolean(in.segments().value("On"));
    if (!on)
        return in.refuse(in.segments().line(), "LOCKSTEP takes {On true} or {On false}");
    lockstep.on = *on;
}

} // namespace usar::protocol
