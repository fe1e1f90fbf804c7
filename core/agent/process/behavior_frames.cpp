#include "core/agent/process/behavior_frames.h"

#include <concepts>
#include <utility>
#include <vector>

#include <QDataStream>
#include <QIODevice>

#include "core/agent/published_text.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"

namespace usar::agent::frames {

namespace {

/// Satisfied by `Plain` and by `const Plain`, so that one list of fields serves writing and reading.
template <class Of, class Plain>
concept Field = std::same_as<std::remove_const_t<Of>, Plain>;

/// The fields of each type in the order of the frame: `io` writes or reads them.
struct FieldLists {
    static void pass(auto&, Field<std::monostate> auto&) {}
    static void pass(auto& io, Field<posh::Symbol> auto& symbol) { io(symbol.text); }
    static void pass(auto& io, Field<LineNumber> auto& line) { io(line.value); }
    static void pass(auto& io, Field<Vec2> auto& point) { io(point.x(), point.y()); }
    static void pass(auto& io, Field<Vec3> auto& point) { io(point.x(), point.y(), point.z()); }
    static void pass(auto& io, Field<Pose> auto& pose) {
        io(pose.position_m, pose.roll_rad, pose.pitch_rad, pose.yaw_rad);
    }
    static void pass(auto& io, Field<Rectangle> auto& area) { io(area.min_m, area.max_m); }
    static void pass(auto& io, Field<PlanText> auto& plan) { io(plan.name, plan.text); }
    static void pass(auto& io, Field<Task> auto& task) {
        io(task.robot_name, task.start_in_map, task.area_in_map, task.dry_above_m);
    }
    static void pass(auto& io, Field<ReplacePlan> auto& asked) { io(asked.plan); }
    static void pass(auto& io, Field<posh::Breakpoint> auto& one) {
        io(one.path, one.names, one.on, one.result, one.key, one.condition, one.skip, one.once, one.enabled);
    }
    static void pass(auto& io, Field<PlanBreakpoint> auto& one) { io(one.id.value, one.what); }
    static void pass(auto& io, Field<SetBreakpoints> auto& asked) { io(asked.breakpoints); }
    static void pass(auto& io, Field<SensePin> auto& pin) { io(pin.call, pin.answer); }
    static void pass(auto& io, Field<ActPin> auto& pin) { io(pin.call, pin.result); }
    static void pass(auto& io, Field<DriveOff> auto& off) { io(off.path, off.names); }
    static void pass(auto& io, Field<SetPins> auto& pins) { io(pins.senses, pins.acts, pins.drives_off); }
    static void pass(auto& io, Field<Job> auto& job) { io(job.behavior_id, job.task, job.parameters, job.plan); }
    static void pass(auto& io, Field<Start> auto& start) { io(start.plugin_file, start.job); }
    static void pass(auto& io, Field<Line> auto& line) { io(line.number, line.text); }
    static void pass(auto& io, Field<by::Other> auto& other) { io(other.name); }
    static void pass(auto& io, Field<by::Behavior> auto& behavior) { io(behavior.behavior_id, behavior.state); }
    static void pass(auto& io, Field<by::Plan> auto& plan) { io(plan.behavior_id, plan.path, plan.why); }
    static void pass(auto& io, Field<by::Hand> auto& hand) { io(hand.what); }
    static void pass(auto& io, Field<by::Session> auto& session) { io(session.why); }
    static void pass(auto& io, Field<by::Operator> auto& user) { io(user.what); }
    static void pass(auto& io, Field<Cause> auto& cause) { io(cause.source, cause.trigger); }
    static void pass(auto& io, Field<CausedCommand> auto& caused) { io(caused.command, caused.cause); }
    static void pass(auto& io, Field<RunningBehavior::Output> auto& output) { io(output.commands, output.published); }
    static void pass(auto& io, Field<Answer> auto& answer) {
        io(answer.output, answer.safe, answer.halted, answer.finished, answer.broke);
    }
    static void pass(auto& io, Field<Error> auto& error) { io(error.what, error.where, error.mend); }
    static void pass(auto& io, Field<Dying> auto& dying) { io(dying.signal); }
    static void pass(auto& io, Field<ParameterSpec> auto& spec) {
        io(spec.id, spec.label, spec.group, spec.unit, spec.default_value);
        io(spec.minimum, spec.maximum, spec.help, spec.choices, spec.minimum_words);
    }
    static void pass(auto& io, Field<ParameterPreset> auto& preset) {
        io(preset.id, preset.name, preset.help, preset.values);
    }
    static void pass(auto& io, Field<BehaviorDescription> auto& behavior) {
        io(behavior.id, behavior.name, behavior.help, behavior.needs_area);
        io(behavior.parameters, behavior.plan_name, behavior.plan_text, behavior.presets);
    }
    static void pass(auto& io, Field<PoshParameter> auto& parameter) {
        io(parameter.name, parameter.default_value, parameter.unit);
        io(parameter.minimum, parameter.maximum, parameter.choices, parameter.help);
    }
    static void pass(auto& io, Field<PrimitiveDescription> auto& primitive) {
        io(primitive.name, primitive.kind, primitive.parameters, primitive.answer, primitive.unit, primitive.help);
        io(primitive.needs, primitive.minimum, primitive.maximum, primitive.choices);
    }
    static void pass(auto& io, Field<Describe> auto& asked) { io(asked.plugin_file); }
    static void pass(auto& io, Field<RobotDescription> auto& robot) {
        io(robot.class_name, robot.name, robot.sensors_needed, robot.behaviors, robot.primitives);
    }
    static void pass(auto& io, Field<TaskPreview> auto& preview) {
        io(preview.path_in_map_m, preview.length_m, preview.duration, preview.summary, preview.outlook);
    }
    static void pass(auto& io, Field<TimeRange> auto& range) { io(range.least, range.most); }
    static void pass(auto& io, Field<TaskOutlook> auto& outlook) {
        io(outlook.duration, outlook.least_sorties, outlook.most_sorties);
        io(outlook.least_coverage_pct, outlook.most_coverage_pct);
    }

    /// The last enumerator of each enumeration, beyond which a number is malformed.
    static constexpr Order last(Order) { return Order::LandNow; }
    static constexpr PlanStep last(PlanStep) { return PlanStep::Cycle; }
    static constexpr posh::BreakOn last(posh::BreakOn) { return posh::BreakOn::Written; }
    static constexpr posh::ActResult last(posh::ActResult) { return posh::ActResult::Failed; }
    static constexpr PrimitiveKind last(PrimitiveKind) { return PrimitiveKind::Act; }
    static constexpr AnswerType last(AnswerType) { return AnswerType::Symbol; }
};

/// The type as which QDataStream passes a number or flag: C++ has two 64-bit types where Qt has one.
template <class Value>
using OnWire = std::conditional_t<std::is_integral_v<Value> && sizeof(Value) == 8, qint64, Value>;

class Put {
public:
    explicit Put(QByteArray& bytes) : stream_(&bytes, QIODevice::WriteOnly) { stream_.setVersion(QDataStream::Qt_6_0); }

    void operator()(const auto&... fields) { (put(fields), ...); }

private:
    template <class Value>
    void put(const Value& value) {
        if constexpr (std::is_arithmetic_v<Value>)
            stream_ << static_cast<OnWire<Value>>(value);
        else if constexpr (std::is_enum_v<Value>)
            put(static_cast<int>(value));
        else
            FieldLists::pass(*this, value);
    }
    void put(const std::string& text) {
        stream_ << QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()));
    }
    void put(Seconds span) { put(span.count()); }
    template <class Value>
    void put(const std::optional<Value>& value) {
        put(value.has_value());
        if (value)
            put(*value);
    }
    template <class Value>
    void put(const std::vector<Value>& values) {
        put(static_cast<quint32>(values.size()));
        for (const Value& value : values)
            put(value);
    }
    void put(const std::map<std::string, ParameterValue>& values) {
        put(static_cast<quint32>(values.size()));
        for (const auto& [key, value] : values)
            (*this)(key, value);
    }
    template <class... Types>
    void put(const std::variant<Types...>& value) {
        put(static_cast<quint32>(value.index()));
        std::visit([this](const auto& one) { put(one); }, value);
    }
    /// Writes a command as a protocol line. A raw command stays raw, even if its words are those of a known command.
    void put(const protocol::Command& command) {
        const auto* const raw = std::get_if<protocol::RawCommand>(&command);
        put(raw != nullptr);
        put(raw ? raw->line : protocol::write(command));
    }
    void put(const Published& value) {
        std::string text;
        appendText(text, value);
        put(text);
    }

    QDataStream stream_;
};

/// After a field that is missing or malformed, `fine` stays false.
class Take {
public:
    explicit Take(const QByteArray& bytes) : stream_(bytes) { stream_.setVersion(QDataStream::Qt_6_0); }

    bool fine() const { return !wrong_ && stream_.status() == QDataStream::Ok; }
    void operator()(auto&... fields) { (take(fields), ...); }

private:
    template <class Value>
    void take(Value& value) {
        if constexpr (std::is_arithmetic_v<Value>) {
            OnWire<Value> wire{};
            stream_ >> wire;
            value = static_cast<Value>(wire);
        } else if constexpr (std::is_enum_v<Value>) {
            int number = 0;
            take(number);
            if (number < 0 || number > static_cast<int>(FieldLists::last(value)))
                wrong_ = true;
            else
                value = static_cast<Value>(number);
        } else {
            FieldLists::pass(*this, value);
        }
    }
    void take(std::string& text) {
        QByteArray bytes;
        stream_ >> bytes;
        text = bytes.toStdString();
    }
    void take(Seconds& span) {
        double count = 0.0;
        take(count);
        span = Seconds(count);
    }
    template <class Value>
    void take(std::optional<Value>& value) {
        bool there = false;
        take(there);
        if (there && fine())
            take(value.emplace());
    }
    template <class Value>
    void take(std::vector<Value>& values) {
        quint32 count = 0;
        take(count);
        for (quint32 i = 0; i < count && fine(); ++i)
            take(values.emplace_back());
    }
    void take(std::map<std::string, ParameterValue>& values) {
        quint32 count = 0;
        take(count);
        for (quint32 i = 0; i < count && fine(); ++i) {
            std::string key;
            take(key);
            take(values[key]);
        }
    }
    template <class... Types>
    void take(std::variant<Types...>& value) {
        quint32 index = 0;
        take(index);
        quint32 number = 0;
        const auto take_one = [&]<class One>(std::type_identity<One>) {
            if (number++ == index && fine())
                take(value.template emplace<One>());
        };
        (take_one(std::type_identity<Types>()), ...);
        wrong_ = wrong_ || index >= sizeof...(Types);
    }
    void take(protocol::Command& command) {
        bool raw = false;
        std::string line;
        (*this)(raw, line);
        Diagnostics ours; // our own line has no problems
        command = raw ? protocol::Command(protocol::RawCommand{line}) : protocol::readCommand(line, ours);
    }
    void take(Published& value) {
        std::string text;
        take(text);
        auto read = readPublished(text);
        wrong_ = wrong_ || !read;
        if (read)
            value = *std::move(read);
    }

    QDataStream stream_;
    bool wrong_ = false;
};

template <class Frame>
QByteArray written(const Frame& frame) {
    QByteArray bytes;
    Put put(bytes);
    put(version);
    put(frame);
    return bytes;
}

template <class Frame>
std::optional<Frame> readAs(const QByteArray& bytes) {
    Take take(bytes);
    quint32 spoken = 0;
    take(spoken);
    if (spoken != version)
        return std::nullopt;
    Frame frame;
    take(frame);
    return take.fine() ? std::optional(std::move(frame)) : std::nullopt;
}

} // namespace

QByteArray write(const Request& request) {
    return written(request);
}

QByteArray write(const Reply& reply) {
    return written(reply);
}

std::optional<Request> readRequest(const QByteArray& frame) {
    return readAs<Request>(frame);
}

std::optional<Reply> readReply(const QByteArray& frame) {
    return readAs<Reply>(frame);
}

} // namespace usar::agent::frames
