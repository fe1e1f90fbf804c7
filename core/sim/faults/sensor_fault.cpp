#include "core/sim/faults/sensor_fault.h"

#include <cmath>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace usar::sim {

namespace {

constexpr double metres_per_degree = 111'200.0; // See robots-and-worlds.md 4.8.

/// Adds the bias to anything that holds numbers.
class Bias {
public:
    explicit Bias(const Fault& fault)
        : by_(fault.number("by"))
        , shift_m_(fault.number("x"), fault.number("y"), fault.number("z"))
        , yaw_rad_(radians(fault.number("yaw_deg"))) {}

    void operator()(double& value) const { value += by_; }
    void operator()(std::vector<double>& values) const {
        for (double& value : values)
            value += by_;
    }
    void operator()(Vec3& value) const { value.array() += by_; }
    void operator()(Pose& pose) const {
        pose.position_m += shift_m_;
        pose.yaw_rad = normalizedAngle(pose.yaw_rad + yaw_rad_);
    }
    template <class Value>
    void operator()(std::optional<Value>& value) const {
        if (value)
            (*this)(*value);
    }
    void operator()(protocol::RangeScan& scan) const { (*this)(scan.ranges_m); }
    void operator()(protocol::GpsReading& gps) const { // The map's x axis points north.
        if (gps.latitude_rad && gps.longitude_rad) {
            *gps.latitude_rad += radians(shift_m_.x() / metres_per_degree);
            *gps.longitude_rad -= radians(shift_m_.y() / (metres_per_degree * std::cos(*gps.latitude_rad)));
        }
    }
    template <class Other>
    void operator()(Other&) const {}

private:
    double by_;
    Vec3 shift_m_;
    double yaw_rad_;
};

template <protocol::Described Owner>
void addTo(const Bias& bias, Owner& owner);

template <class Owner>
void addToGroups(const Bias& bias, Owner& owner) {
    if constexpr (protocol::HasGroups<Owner>)
        for (auto& element : owner.*Owner::groups().member)
            addTo(bias, element);
}

template <protocol::Described Owner>
void addTo(const Bias& bias, Owner& owner) {
    protocol::forEachItem<Owner>([&](const auto& item) { bias(owner.*(item.member)); });
    addToGroups(bias, owner);
}

} // namespace

void addBias(const Fault& fault, protocol::InfoMessage& message) {
    const Bias bias(fault);
    std::visit(
        [&](auto& one) {
            using One = std::decay_t<decltype(one)>;
            if constexpr (protocol::SensorMessage<One> && protocol::Described<One>)
                addTo(bias, one);
            else if constexpr (protocol::SensorMessage<One>)
                bias(one);
        },
        static_cast<protocol::InfoVariant&>(message));
}

void sayAgain(Seconds now, protocol::InfoMessage& frozen) {
    std::visit(
        [&](auto& one) {
            if constexpr (requires { one.time = now; })
                if (one.time)
                    one.time = now;
        },
        static_cast<protocol::InfoVariant&>(frozen));
}

void addLine(protocol::InfoMessage&& message, std::vector<protocol::InfoMessage>& out) {
    const bool joined = std::visit(
        [&](auto& one) {
            using One = std::decay_t<decltype(one)>;
            if constexpr (protocol::SensorMessage<One> && protocol::NamedGroups<One>) {
                auto* const line = out.empty() ? nullptr : std::get_if<One>(&out.back());
                if (!line || protocol::wireTypeOf(*line) != protocol::wireTypeOf(one))
                    return false;
                auto& own = one.*One::groups().member;
                auto& all = line->*One::groups().member;
                all.insert(all.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
                return true;
            } else {
                return false;
            }
        },
        static_cast<protocol::InfoVariant&>(message));
    if (!joined)
        out.push_back(std::move(message));
}

} // namespace usar::sim
