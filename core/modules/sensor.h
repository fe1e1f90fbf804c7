// The newest reading of every sensor, by type and name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/protocol/info_message.h"

namespace usar::modules {

/// A reading and when it came: its own time where it carries one, else the clock at arrival.
template <class Value>
struct Stamped {
    Value value;
    Seconds time{0.0};
    LineNumber line;
};

/// Non-queued sensor module of the thesis (3.3): a new reading replaces the old one of the same type and name; a bare
/// head
/// ("no news") replaces nothing. Pointers live until the next `take`.
class SensorModule {
public:
    /// `now` is the protocol clock, used for readings without a time of their own.
    void take(const protocol::InfoLine& line, Seconds now);

    const Stamped<protocol::NamedRange>* sonar(const std::string& name) const;
    /// All sonars, by name.
    const std::map<std::string, Stamped<protocol::NamedRange>>& sonars() const { return sonars_; }
    /// The scanner with this name; an empty name means the first one that spoke.
    const Stamped<protocol::RangeScan>* scan(const std::string& name = {}) const;
    const Stamped<protocol::InsReading>* ins() const { return ins_ ? &*ins_ : nullptr; }
    const Stamped<protocol::GroundTruthReading>* groundTruth() const {
        return ground_truth_ ? &*ground_truth_ : nullptr;
    }
    const Stamped<protocol::OdometryReading>* odometry() const { return odometry_ ? &*odometry_ : nullptr; }
    const Stamped<protocol::EncoderTicks>* encoder(const std::string& name) const;
    /// Sensors of types that no table knows, and damaged lines of known ones: newest line by (type, name), the type in
    /// any case.
    const Stamped<protocol::GenericMessage>* generic(const std::string& type, const std::string& name) const;

private:
    struct Arrival {
        Seconds time{0.0};
        LineNumber line;
    };

    void file(const protocol::SonarReadings& message);
    void file(const protocol::RangeScan& message);
    void file(const protocol::InsReading& message);
    void file(const protocol::GroundTruthReading& message);
    void file(const protocol::OdometryReading& message);
    void file(const protocol::EncoderReadings& message);
    void file(const protocol::GenericMessage& message);
    /// Everything that is no sensor's.
    template <class Other>
    void file(const Other&) {}
    template <class Value>
    Stamped<Value> stamped(const Value& value) const {
        return {value, arrival_.time, arrival_.line};
    }

    Arrival arrival_; ///< of the line that is being filed
    std::map<std::string, Stamped<protocol::NamedRange>> sonars_;
    std::map<std::string, Stamped<protocol::RangeScan>> scans_;
    std::string first_scanner_;
    std::optional<Stamped<protocol::InsReading>> ins_;
    std::optional<Stamped<protocol::GroundTruthReading>> ground_truth_;
    std::optional<Stamped<protocol::OdometryReading>> odometry_;
    std::map<std::string, Stamped<protocol::EncoderTicks>> encoders_;
    std::map<std::pair<std::string, std::string>, Stamped<protocol::GenericMessage>> generic_;
};

} // namespace usar::modules
