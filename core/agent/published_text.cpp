#include "core/agent/published_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>

#include "core/base/numbers.h"
#include "core/base/quoted_text.h"
#include "core/base/text.h"

namespace usar::agent {

namespace {

/// The first word of each text, in the order of PublishedVariant.
constexpr std::array<std::string_view, std::variant_size_v<PublishedVariant>> words{
    "status", "pose",     "mark",  "scan",   "path",    "goal",    "zones",
    "event",  "finished", "trace", "halted", "resumed", "replaced"};

/// Satisfied by `Plain` and by `const Plain`, so that one list of fields serves writing and reading.
template <class Of, class Plain>
concept Field = std::same_as<std::remove_const_t<Of>, Plain>;

/// The fields of each type in the order of the text: `io` writes or reads them. A list has no end mark, so it comes
/// last.
struct FieldLists {
    static void pass(auto& io, Field<LineNumber> auto& line) { io(line.value); }
    static void pass(auto& io, Field<Vec2> auto& point) { io(point.x(), point.y()); }
    static void pass(auto& io, Field<Vec3> auto& point) { io(point.x(), point.y(), point.z()); }
    static void pass(auto& io, Field<Pose> auto& pose) {
        io(pose.position_m, pose.roll_rad, pose.pitch_rad, pose.yaw_rad);
    }
    static void pass(auto& io, Field<BehaviorStatus> auto& status) {
        io(status.time, status.elapsed, status.state, status.distance_to_goal_m, status.battery_used_pct);
        io(status.range_left_m, status.progress_pct, status.time_left, status.distance_flown_m, status.charges);
        io(status.paused);
        io.trailing(status.time_left_range);
    }
    static void pass(auto& io, Field<TimeRange> auto& range) { io(range.least, range.most); }
    static void pass(auto& io, Field<PoseEstimate> auto& estimate) { io(estimate.time, estimate.base_in_map); }
    static void pass(auto& io, Field<MapMark> auto& mark) {
        io(mark.kind, mark.position_in_map_m, mark.time, mark.line);
    }
    static void pass(auto& io, Field<ScanPlacement> auto& scan) { io(scan.scan_line, scan.scanner_in_map); }
    static void pass(auto& io, Field<PlannedPath> auto& path) { io(path.points_in_map_m); }
    static void pass(auto& io, Field<CurrentGoal> auto& goal) { io(goal.goal_in_map_m); }
    static void pass(auto& io, Field<SonarZone> auto& zone) {
        io(zone.name, zone.bearing_rad, zone.range_m, zone.maximum_m, zone.low_risk_below_m, zone.high_risk_below_m);
        io(zone.risk);
    }
    static void pass(auto& io, Field<SonarZones> auto& zones) { io(zones.zones); }
    static void pass(auto& io, Field<BehaviorEvent> auto& event) { io(event.severity, event.text); }
    static void pass(auto& io, Field<BehaviorFinished> auto& finished) {
        io(finished.success, finished.reason, finished.sensors_missing);
    }
    static void pass(auto& io, Field<PlanTrace> auto& trace) { io(trace.bytes); }
    static void pass(auto& io, Field<BreakpointId> auto& id) { io(id.value); }
    static void pass(auto& io, Field<PlanHalted> auto& halted) {
        io(halted.cycle, halted.time, halted.breakpoint, halted.path, halted.reason);
    }
    static void pass(auto&, Field<PlanResumed> auto&) {}
    static void pass(auto& io, Field<posh::Spot> auto& at) { io(at.line, at.column, at.offset, at.length); }
    static void pass(auto& io, Field<posh::Finding> auto& found) {
        io(found.code, found.at, found.opener, found.message);
    }
    static void pass(auto& io, Field<PlanReplaced> auto& replaced) {
        io(replaced.fate, replaced.plan_name, replaced.cycle, replaced.reason, replaced.findings);
    }

    /// The last enumerator of each enumeration, beyond which a number is malformed.
    static constexpr MarkKind last(MarkKind) { return MarkKind::GoalGivenUp; }
    static constexpr Risk last(Risk) { return Risk::High; }
    static constexpr Severity last(Severity) { return Severity::Error; }
    static constexpr PlanFate last(PlanFate) { return PlanFate::Refused; }
    static constexpr posh::Code last(posh::Code) { return posh::Code::UndeclaredArgument; }
};

/// Appends fields to a text, each after a blank.
class Writer {
public:
    explicit Writer(std::string& text) : text_(text) {}

    void operator()(const auto&... fields) { (add(fields), ...); }
    void trailing(const auto& field) { add(field); }

private:
    void add(double value) {
        text_ += ' ';
        if (std::isfinite(value))
            appendShortest(text_, value);
        else
            text_ += "nan";
    }
    void add(Seconds value) { add(value.count()); }
    void add(const std::integral auto& value) { (text_ += ' ') += std::to_string(value); }
    void add(const std::string& value) { appendQuoted(text_ += ' ', value); }
    template <class Value>
    void add(const std::optional<Value>& value) {
        if (value)
            add(*value);
        else
            text_ += " -";
    }
    template <class Value>
    void add(const std::vector<Value>& values) {
        for (const Value& value : values)
            add(value);
    }
    template <class Value>
    void add(const Value& value) {
        if constexpr (std::is_enum_v<Value>)
            add(static_cast<int>(value));
        else
            FieldLists::pass(*this, value);
    }

    std::string& text_;
};

/// Removes fields from a text. After a field that is missing or malformed, `fine` stays false.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    std::string_view word() { return takeWord(rest_); }
    bool fine() { return fine_ && done(); }
    void operator()(auto&... fields) { (take(fields), ...); }
    /// A field that recordings of earlier versions do not have.
    void trailing(auto& optional) {
        if (!done())
            take(optional);
    }

private:
    bool done() { return (rest_ = trimmed(rest_)).empty(); }

    void take(double& value) {
        const auto number = readNumber(word());
        fine_ = fine_ && number;
        value = number.value_or(0.0);
    }
    void take(Seconds& value) {
        double seconds = 0.0;
        take(seconds);
        value = Seconds{seconds};
    }
    void take(bool& value) {
        int number = 0;
        take(number);
        value = number != 0;
    }
    void take(std::integral auto& value) {
        const std::string_view text = word();
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        fine_ = fine_ && error == std::errc() && end == text.data() + text.size();
    }
    void take(std::string& value) { fine_ = takeQuoted(rest_, value) && fine_; }
    template <class Value>
    void take(std::optional<Value>& value) {
        rest_ = trimmed(rest_);
        if (rest_.starts_with("-") && (rest_.size() == 1 || rest_[1] == ' '))
            word();
        else
            take(value.emplace());
    }
    template <class Value>
    void take(std::vector<Value>& values) {
        while (!done())
            take(values.emplace_back());
    }
    template <class Value>
    void take(Value& value) {
        if constexpr (std::is_enum_v<Value>) {
            int number = 0;
            take(number);
            fine_ = fine_ && number >= 0 && number <= static_cast<int>(FieldLists::last(value));
            value = static_cast<Value>(number);
        } else {
            FieldLists::pass(*this, value);
        }
    }

    std::string_view rest_;
    bool fine_ = true;
};

template <class... Values>
std::optional<Published> readOneOf(std::string_view text, std::type_identity<std::variant<Values...>>) {
    Reader reader(text);
    const std::string_view word = reader.word();
    std::optional<Published> read;
    const auto readAs = [&]<class Value>(std::string_view known, std::type_identity<Value>) {
        if (known != word)
            return;
        Value value;
        reader(value);
        if (reader.fine())
            read = std::move(value);
    };
    std::size_t index = 0;
    (readAs(words[index++], std::type_identity<Values>()), ...);
    return read;
}

} // namespace

void appendText(std::string& text, const Published& value) {
    text += words[value.index()];
    std::visit(Writer(text), value);
}

std::optional<Published> readPublished(std::string_view text) {
    return readOneOf(text, std::type_identity<PublishedVariant>());
}

} // namespace usar::agent
