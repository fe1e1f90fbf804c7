#include "widgets/models/newest_lines.h"

#include <utility>

namespace usar::widgets {

namespace {

struct NameOf {
    std::string operator()(const protocol::GenericMessage& m) const {
        return m.type_word + ' ' + m.type + ' ' + m.name;
    }
    std::string operator()(const protocol::PackageState& m) const { return m.name; }
    std::string operator()(const protocol::EffecterState& m) const { return m.type + ' ' + m.name; }
    /// Type and first name, because all sensors of a group always arrive together.
    template <protocol::SensorMessage Sensor>
    std::string operator()(const Sensor& m) const {
        std::string stream(protocol::wireTypeOf(m));
        bool first = true;
        protocol::forEachReading(m, [&](const std::string& name, const auto&) {
            if (std::exchange(first, false))
                (stream += ' ') += name;
        });
        return stream;
    }
    std::string operator()(const protocol::GeometryInfo& m) const { return withFirst(m); }
    std::string operator()(const protocol::ConfigurationInfo& m) const { return withFirst(m); }
    std::string operator()(const protocol::Response& m) const { return m.type + ' ' + m.name; }
    std::string operator()(const auto&) const { return {}; }

private:
    static std::string withFirst(const auto& m) {
        return m.type + ' ' + (m.items.empty() ? std::string() : m.items.front().name);
    }
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
