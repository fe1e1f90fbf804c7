#include "widgets/models/newest_lines.h"

#include <utility>

namespace usar::widgets {

namespace {

struct NameOf {
    std::string operator()(const protocol::GenericMessage& m) const {
        return m.type_word + ' ' + m.type + ' ' + m.name;
    }
    std::string operator()(const protocol::SonarReadings& m) const {
        return m.ranges.empty() ? std::string() : m.ranges.front().name;
    }
    std::string operator()(const protocol::EncoderReadings& m) const {
        return m.encoders.empty() ? std::string() : m.encoders.front().name;
    }
    std::string operator()(const protocol::RangeScan& m) const { return m.name; }
    std::string operator()(const protocol::InsReading& m) const { return m.name; }
    std::string operator()(const protocol::GroundTruthReading& m) const { return m.name; }
    std::string operator()(const protocol::OdometryReading& m) const { return m.name; }
    std::string operator()(const protocol::GeometryInfo& m) const {
        return m.type + ' ' + (m.items.empty() ? std::string() : m.items.front().name);
    }
    std::string operator()(const protocol::ConfigurationInfo& m) const {
        return m.type + ' ' + (m.items.empty() ? std::string() : m.items.front().name);
    }
    std::string operator()(const protocol::Response& m) const { return m.type + ' ' + m.name; }
    std::string operator()(const auto&) const { return {}; }
};

} // namespace

std::string streamOf(const protocol::InfoMessage& message) {
    return std::to_string(message.index()) + ' ' + std::visit(NameOf{}, message);
}

void NewestLines::take(const protocol::InfoLine& line, Seconds now) {
    const auto [place, is_new] = places_.try_emplace(streamOf(line.message), lines_.size());
    if (is_new)
        lines_.emplace_back();
    CountedLine& counted = lines_[place->second];
    counted.line = line;
    counted.now = now;
    ++counted.count;
}

std::vector<CountedLine> NewestLines::takeAll() {
    places_.clear();
    return std::exchange(lines_, {});
}

} // namespace usar::widgets
