#include "core/agent/published_text.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/quoted_text.h"
#include "core/base/text.h"

namespace usar::agent {

namespace {

class Writer {
public:
    explicit Writer(std::string& text) : text_(text) {}

    void word(std::string_view word) { text_ += word; }
    void add(double value) {
        text_ += ' ';
        if (std::isfinite(value))
            appendShortest(text_, value);
        else
            text_ += "nan";
    }
    void add(Seconds value) { add(value.count()); }
    void add(int value) { (text_ += ' ') += std::to_string(value); }
    void add(std::uint64_t value) { (text_ += ' ') += std::to_string(value); }
    void add(const posh::Spot& spot) {
        for (const std::uint32_t number : {spot.line, spot.column, spot.offset, spot.length})
            add(std::uint64_t{number});
    }
    void add(LineNumber value) { (text_ += ' ') += std::to_string(value.value); }
    void add(const std::string& value) {
        text_ += ' ';
        appendQuoted(text_, value);
    }
    void add(const Vec2& point) { (add(point.x()), add(point.y())); }
    void add(const Vec3& point) { (add(point.x()), add(point.y()), add(point.z())); }
    void add(const Pose& pose) { (add(pose.position_m), add(pose.roll_rad), add(pose.pitch_rad), add(pose.yaw_rad)); }
    template <class Value>
    void add(const std::optional<Value>& value) {
        if (value)
            add(*value);
        else
            text_ += " -";
    }

    void operator()(const BehaviorStatus& status) {
        word("status");
        (add(status.time), add(status.elapsed), add(status.state));
        (add(status.distance_to_goal_m), add(status.battery_used_pct), add(status.range_left_m));
        (add(status.progress_pct), add(status.time_left), add(status.distance_flown_m));
        (add(status.charges), add(int{status.paused}));
    }
    void operator()(const PoseEstimate& estimate) {
        word("pose");
        (add(estimate.time), add(estimate.base_in_map));
    }
    void operator()(const MapMark& mark) {
        word("mark");
        (add(static_cast<int>(mark.kind)), add(mark.position_in_map_m), add(mark.time), add(mark.line));
    }
    void operator()(const ScanPlacement& placement) {
        word("scan");
        (add(placement.scan_line), add(placement.scanner_in_map));
    }
    void operator()(const PlannedPath& path) {
        word("path");
        for (const Vec2& point : path.points_in_map_m)
            add(point);
    }
    void operator()(const CurrentGoal& goal) {
        word("goal");
        add(goal.goal_in_map_m);
    }
    void operator()(const SonarZones& zones) {
        word("zones");
        for (const SonarZone& zone : zones.zones) {
            (add(zone.name), add(zone.bearing_rad), add(zone.range_m), add(zone.maximum_m));
            (add(zone.low_risk_below_m), add(zone.high_risk_below_m), add(static_cast<int>(zone.risk)));
        }
    }
    void operator()(const BehaviorEvent& event) {
        word("event");
        (add(static_cast<int>(event.severity)), add(event.text));
    }
    void operator()(const BehaviorFinished& finished) {
        word("finished");
        (add(int{finished.success}), add(finished.reason));
    }
    void operator()(const PlanTrace& trace) {
        word("trace");
        add(trace.bytes);
    }
    void operator()(const PlanHalted& halted) {
        word("halted");
        (add(halted.cycle), add(halted.time), add(halted.breakpoint), add(halted.path), add(halted.reason));
    }
    void operator()(const PlanResumed&) { word("resumed"); }
    void operator()(const PlanReplaced& replaced) {
        word("replaced");
        (add(static_cast<int>(replaced.fate)), add(replaced.plan_name), add(replaced.cycle), add(replaced.reason));
        for (const posh::Finding& finding : replaced.findings)
            (add(static_cast<int>(finding.code)), add(finding.at), add(finding.opener), add(finding.message));
    }

private:
    std::string& text_;
};

/// Removes fields from a text. After a field that is missing or malformed, `fine` stays false.
class Fields {
public:
    explicit Fields(std::string_view text) : rest_(text) {}

    bool done() {
        rest_ = trimmed(rest_);
        return rest_.empty();
    }
    bool fine() { return fine_ && done(); }
    std::string_view word() { return takeWord(rest_); }

    void take(double& value) {
        const std::string_view text = takeWord(rest_);
        const auto number = readNumber(text);
        fine_ = fine_ && number;
        value = number.value_or(0.0);
    }
    void take(Seconds& value) {
        double seconds = 0.0;
        take(seconds);
        value = Seconds{seconds};
    }
    void take(LineNumber& value) { takeWhole(value.value); }
    void take(std::string& value) { fine_ = takeQuoted(rest_, value) && fine_; }
    void take(Vec2& point) { (take(point.x()), take(point.y())); }
    void take(Vec3& point) { (take(point.x()), take(point.y()), take(point.z())); }
    void take(Pose& pose) { (take(pose.position_m), take(pose.roll_rad), take(pose.pitch_rad), take(pose.yaw_rad)); }
    void take(bool& value) {
        int number = 0;
        takeWhole(number);
        value = number != 0;
    }
    void take(int& value) { takeWhole(value); }
    void take(std::uint64_t& value) { takeWhole(value); }
    void take(posh::Spot& spot) {
        for (std::uint32_t* const number : {&spot.line, &spot.column, &spot.offset, &spot.length})
            takeWhole(*number);
    }
    /// Takes an enumerator by its number, up to `last`.
    template <class Enum>
    void takeOneOf(Enum& value, Enum last) {
        int number = 0;
        takeWhole(number);
        fine_ = fine_ && number >= 0 && number <= static_cast<int>(last);
        value = static_cast<Enum>(number);
    }
    template <class Value>
    void take(std::optional<Value>& value) {
        rest_ = trimmed(rest_);
        if (rest_.starts_with("-") && (rest_.size() == 1 || rest_[1] == ' '))
            takeWord(rest_);
        else
            take(value.emplace());
    }

private:
    template <class Integer>
    void takeWhole(Integer& value) {
        const std::string_view text = takeWord(rest_);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        fine_ = fine_ && error == std::errc() && end == text.data() + text.size();
    }

    std::string_view rest_;
    bool fine_ = true;
};

void read(Fields& fields, BehaviorStatus& status) {
    (fields.take(status.time), fields.take(status.elapsed), fields.take(status.state));
    (fields.take(status.distance_to_goal_m), fields.take(status.battery_used_pct), fields.take(status.range_left_m));
    (fields.take(status.progress_pct), fields.take(status.time_left), fields.take(status.distance_flown_m));
    (fields.take(status.charges), fields.take(status.paused));
}
void read(Fields& fields, PoseEstimate& estimate) {
    (fields.take(estimate.time), fields.take(estimate.base_in_map));
}
void read(Fields& fields, MapMark& mark) {
    fields.takeOneOf(mark.kind, MarkKind::GoalGivenUp);
    (fields.take(mark.position_in_map_m), fields.take(mark.time), fields.take(mark.line));
}
void read(Fields& fields, ScanPlacement& placement) {
    (fields.take(placement.scan_line), fields.take(placement.scanner_in_map));
}
void read(Fields& fields, PlannedPath& path) {
    while (!fields.done())
        fields.take(path.points_in_map_m.emplace_back(Vec2::Zero()));
}
void read(Fields& fields, CurrentGoal& goal) {
    fields.take(goal.goal_in_map_m);
}
void read(Fields& fields, SonarZones& zones) {
    while (!fields.done()) {
        SonarZone& zone = zones.zones.emplace_back();
        (fields.take(zone.name), fields.take(zone.bearing_rad), fields.take(zone.range_m), fields.take(zone.maximum_m));
        (fields.take(zone.low_risk_below_m), fields.take(zone.high_risk_below_m));
        fields.takeOneOf(zone.risk, Risk::High);
    }
}
void read(Fields& fields, BehaviorEvent& event) {
    fields.takeOneOf(event.severity, Severity::Error);
    fields.take(event.text);
}
void read(Fields& fields, BehaviorFinished& finished) {
    (fields.take(finished.success), fields.take(finished.reason));
}
void read(Fields& fields, PlanTrace& trace) {
    fields.take(trace.bytes);
}

void read(Fields& fields, PlanHalted& halted) {
    (fields.take(halted.cycle), fields.take(halted.time), fields.take(halted.breakpoint));
    (fields.take(halted.path), fields.take(halted.reason));
}
void read(Fields&, PlanResumed&) {}
void read(Fields& fields, PlanReplaced& replaced) {
    fields.takeOneOf(replaced.fate, PlanFate::Refused);
    (fields.take(replaced.plan_name), fields.take(replaced.cycle), fields.take(replaced.reason));
    while (!fields.done()) {
        posh::Finding& finding = replaced.findings.emplace_back();
        fields.takeOneOf(finding.code, posh::Code::UndeclaredArgument);
        (fields.take(finding.at), fields.take(finding.opener), fields.take(finding.message));
    }
}

template <class Value>
std::optional<Published> readAs(Fields& fields) {
    Value value;
    read(fields, value);
    return fields.fine() ? std::optional<Published>(std::move(value)) : std::nullopt;
}

} // namespace

void appendText(std::string& text, const Published& value) {
    std::visit(Writer(text), value);
}

std::optional<Published> readPublished(std::string_view text) {
    using Read = std::optional<Published> (*)(Fields&);
    static constexpr std::pair<std::string_view, Read> readers[]{
        {"status", readAs<BehaviorStatus>}, {"pose", readAs<PoseEstimate>},   {"mark", readAs<MapMark>},
        {"scan", readAs<ScanPlacement>},    {"path", readAs<PlannedPath>},    {"goal", readAs<CurrentGoal>},
        {"zones", readAs<SonarZones>},      {"event", readAs<BehaviorEvent>}, {"finished", readAs<BehaviorFinished>},
        {"trace", readAs<PlanTrace>},       {"halted", readAs<PlanHalted>},   {"resumed", readAs<PlanResumed>},
        {"replaced", readAs<PlanReplaced>}};
    Fields fields(text);
    const std::string_view word = fields.word();
    for (const auto& [known, reader] : readers)
        if (known == word)
            return reader(fields);
    return std::nullopt;
}

} // namespace usar::agent
