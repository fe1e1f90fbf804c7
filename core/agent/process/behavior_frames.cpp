#include "core/agent/process/behavior_frames.h"

#include <type_traits>
#include <utility>
#include <vector>

#include <QDataStream>
#include <QIODevice>

#include "core/agent/published_text.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"

namespace usar::agent::frames {

namespace {

// Each type has one list of fields for both directions: `Put` writes the fields, `Take` reads them.
class Put {
public:
    explicit Put(QByteArray& bytes) : stream_(&bytes, QIODevice::WriteOnly) { stream_.setVersion(QDataStream::Qt_6_0); }

    void operator()(const std::string& text) {
        stream_ << QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()));
    }
    void operator()(bool value) { stream_ << value; }
    void operator()(int value) { stream_ << static_cast<qint32>(value); }
    void operator()(quint32 value) { stream_ << value; }
    void operator()(double value) { stream_ << value; }
    void operator()(long long value) { stream_ << static_cast<qint64>(value); }
    void operator()(std::int64_t value) { stream_ << static_cast<qint64>(value); }
    void operator()(std::uint64_t value) { stream_ << static_cast<quint64>(value); }
    bool fine() const { return true; }

private:
    QDataStream stream_;
};

class Take {
public:
    explicit Take(const QByteArray& bytes) : stream_(bytes) { stream_.setVersion(QDataStream::Qt_6_0); }

    void operator()(std::string& text) {
        QByteArray bytes;
        stream_ >> bytes;
        text = bytes.toStdString();
    }
    void operator()(bool& value) { stream_ >> value; }
    void operator()(int& value) { as<qint32>(value); }
    void operator()(quint32& value) { stream_ >> value; }
    void operator()(double& value) { stream_ >> value; }
    void operator()(long long& value) { as<qint64>(value); }
    void operator()(std::int64_t& value) { as<qint64>(value); }
    void operator()(std::uint64_t& value) { as<quint64>(value); }
    bool fine() const { return !wrong_ && stream_.status() == QDataStream::Ok; }
    void spoil() { wrong_ = true; }

private:
    template <class Wire, class Value>
    void as(Value& value) {
        Wire wire{};
        stream_ >> wire;
        value = static_cast<Value>(wire);
    }

    QDataStream stream_;
    bool wrong_ = false;
};

template <class Enum>
void passEnum(Put& put, const Enum& value, Enum) {
    put(static_cast<int>(value));
}
template <class Enum>
void passEnum(Take& take, Enum& value, Enum last) {
    int number = 0;
    take(number);
    if (number < 0 || number > static_cast<int>(last))
        take.spoil();
    else
        value = static_cast<Enum>(number);
}

template <class Io, class Fields>
requires std::is_invocable_v<Io&, Fields&>
void pass(Io& io, Fields& field) {
    io(field);
}

template <class Value>
void pass(Put& put, const std::optional<Value>& value) {
    put(value.has_value());
    if (value)
        pass(put, *value);
}
template <class Value>
void pass(Take& take, std::optional<Value>& value) {
    bool there = false;
    take(there);
    if (there && take.fine())
        pass(take, value.emplace());
}

template <class Value>
void pass(Put& put, const std::vector<Value>& values) {
    put(static_cast<quint32>(values.size()));
    for (const Value& value : values)
        pass(put, value);
}
template <class Value>
void pass(Take& take, std::vector<Value>& values) {
    quint32 count = 0;
    take(count);
    for (quint32 i = 0; i < count && take.fine(); ++i)
        pass(take, values.emplace_back());
}

template <class Value>
void pass(Put& put, const std::map<std::string, Value>& values) {
    put(static_cast<quint32>(values.size()));
    for (const auto& [key, value] : values)
        (pass(put, key), pass(put, value));
}
template <class Value>
void pass(Take& take, std::map<std::string, Value>& values) {
    quint32 count = 0;
    take(count);
    for (quint32 i = 0; i < count && take.fine(); ++i) {
        std::string key;
        pass(take, key);
        pass(take, values[key]);
    }
}

template <class... Types>
void pass(Put& put, const std::variant<Types...>& value) {
    put(static_cast<quint32>(value.index()));
    std::visit([&](const auto& one) { pass(put, one); }, value);
}
template <class... Types>
void pass(Take& take, std::variant<Types...>& value) {
    quint32 index = 0;
    take(index);
    quint32 number = 0;
    const auto taken = [&]<class One>(std::type_identity<One>) {
        if (number++ == index && take.fine())
            pass(take, value.template emplace<One>());
    };
    (taken(std::type_identity<Types>()), ...);
    if (index >= sizeof...(Types))
        take.spoil();
}

template <class Io>
void pass(Io&, const std::monostate&) {}
void pass(Put& put, const Order& order) {
    passEnum(put, order, Order::LandNow);
}
void pass(Take& take, Order& order) {
    passEnum(take, order, Order::LandNow);
}
void pass(Put& put, const PlanStep& step) {
    passEnum(put, step, PlanStep::Cycle);
}
void pass(Take& take, PlanStep& step) {
    passEnum(take, step, PlanStep::Cycle);
}

/// Satisfied by `Plain` and by `const Plain`: with it, one function serves reading and writing.
template <class Of, class Plain>
concept Either = std::is_same_v<std::remove_const_t<Of>, Plain>;

void pass(auto& io, Either<posh::Symbol> auto& symbol) {
    pass(io, symbol.text);
}
void pass(auto& io, Either<LineNumber> auto& line) {
    pass(io, line.value);
}
void pass(auto& io, Either<Vec2> auto& point) {
    (pass(io, point.x()), pass(io, point.y()));
}
void pass(auto& io, Either<Pose> auto& pose) {
    (pass(io, pose.position_m.x()), pass(io, pose.position_m.y()), pass(io, pose.position_m.z()));
    (pass(io, pose.roll_rad), pass(io, pose.pitch_rad), pass(io, pose.yaw_rad));
}
void pass(auto& io, Either<PlanText> auto& plan) {
    (pass(io, plan.name), pass(io, plan.text));
}
void pass(auto& io, Either<Task> auto& task) {
    (pass(io, task.robot_name), pass(io, task.start_in_map));
    (pass(io, task.area_in_map.min_m), pass(io, task.area_in_map.max_m));
}
void pass(auto& io, Either<ReplacePlan> auto& asked) {
    pass(io, asked.plan);
}
void pass(auto& io, Either<PlanBreakpoint> auto& one) {
    (pass(io, one.id), pass(io, one.what.path), pass(io, one.what.names));
    (passEnum(io, one.what.on, posh::BreakOn::Written), passEnum(io, one.what.result, posh::ActResult::Failed));
    (pass(io, one.what.key), pass(io, one.what.condition), pass(io, one.what.skip), pass(io, one.what.once),
     pass(io, one.what.enabled));
}
void pass(auto& io, Either<SetBreakpoints> auto& asked) {
    pass(io, asked.breakpoints);
}
void pass(auto& io, Either<SensePin> auto& pin) {
    (pass(io, pin.call), pass(io, pin.answer));
}
void pass(auto& io, Either<ActPin> auto& pin) {
    (pass(io, pin.call), passEnum(io, pin.result, posh::ActResult::Failed));
}
void pass(auto& io, Either<DriveOff> auto& off) {
    (pass(io, off.path), pass(io, off.names));
}
void pass(auto& io, Either<SetPins> auto& pins) {
    (pass(io, pins.senses), pass(io, pins.acts), pass(io, pins.drives_off));
}
void pass(auto& io, Either<Start> auto& start) {
    (pass(io, start.plugin_file), pass(io, start.behavior_id), pass(io, start.task));
    (pass(io, start.parameters), pass(io, start.plan));
}
void pass(auto& io, Either<Line> auto& line) {
    (pass(io, line.number), pass(io, line.text));
}

/// Passes a command as a protocol line. A raw command stays raw, even if its words are those of a known command.
void pass(Put& put, const protocol::Command& command) {
    const auto* const raw = std::get_if<protocol::RawCommand>(&command);
    put(raw != nullptr);
    put(raw ? raw->line : protocol::write(command));
}
void pass(Take& take, protocol::Command& command) {
    bool raw = false;
    std::string line;
    (take(raw), take(line));
    Diagnostics ours; // our own line has no problems
    command = raw ? protocol::Command(protocol::RawCommand{line}) : protocol::readCommand(line, ours);
}
void pass(Put& put, const Published& value) {
    std::string text;
    appendText(text, value);
    put(text);
}
void pass(Take& take, Published& value) {
    std::string text;
    take(text);
    auto read = readPublished(text);
    if (read)
        value = *std::move(read);
    else
        take.spoil();
}
void pass(auto& io, Either<CausedCommand> auto& caused) {
    (pass(io, caused.command), pass(io, caused.cause.source), pass(io, caused.cause.trigger));
}
void pass(auto& io, Either<Answer> auto& answer) {
    (pass(io, answer.output.commands), pass(io, answer.output.published));
    (pass(io, answer.safe), pass(io, answer.halted), pass(io, answer.finished), pass(io, answer.broke));
}
void pass(auto& io, Either<Refusal> auto& refusal) {
    (pass(io, refusal.error.what), pass(io, refusal.error.where), pass(io, refusal.error.mend));
}
void pass(auto& io, Either<Dying> auto& dying) {
    pass(io, dying.signal);
}

void pass(auto& io, Either<ParameterSpec> auto& spec) {
    (pass(io, spec.id), pass(io, spec.label), pass(io, spec.group), pass(io, spec.unit), pass(io, spec.default_value));
    (pass(io, spec.minimum), pass(io, spec.maximum), pass(io, spec.help), pass(io, spec.choices));
}
void pass(auto& io, Either<BehaviorDescription> auto& behavior) {
    (pass(io, behavior.id), pass(io, behavior.name), pass(io, behavior.help), pass(io, behavior.needs_area));
    (pass(io, behavior.parameters), pass(io, behavior.plan_name), pass(io, behavior.plan_text));
}
void pass(auto& io, Either<PoshParameter> auto& parameter) {
    (pass(io, parameter.name), pass(io, parameter.default_value), pass(io, parameter.unit));
    (pass(io, parameter.minimum), pass(io, parameter.maximum), pass(io, parameter.choices), pass(io, parameter.help));
}
void pass(auto& io, Either<PrimitiveDescription> auto& primitive) {
    (pass(io, primitive.name), passEnum(io, primitive.kind, PrimitiveKind::Act), pass(io, primitive.parameters));
    (passEnum(io, primitive.answer, AnswerType::Symbol), pass(io, primitive.unit), pass(io, primitive.help));
    (pass(io, primitive.needs), pass(io, primitive.minimum), pass(io, primitive.maximum), pass(io, primitive.choices));
}
void pass(auto& io, Either<Describe> auto& asked) {
    pass(io, asked.plugin_file);
}
void pass(auto& io, Either<Description> auto& description) {
    auto& robot = description.robot;
    (pass(io, robot.class_name), pass(io, robot.name), pass(io, robot.sensors_needed), pass(io, robot.behaviors));
    pass(io, robot.primitives);
}
void pass(auto& io, Either<Preview> auto& asked) {
    (pass(io, asked.behavior_id), pass(io, asked.task), pass(io, asked.parameters), pass(io, asked.plan));
}
void pass(auto& io, Either<Seconds> auto& span) {
    double count = span.count();
    pass(io, count);
    if constexpr (!std::is_const_v<std::remove_reference_t<decltype(span)>>)
        span = Seconds(count);
}
void pass(auto& io, Either<TaskPreview> auto& preview) {
    (pass(io, preview.path_in_map_m), pass(io, preview.length_m), pass(io, preview.duration));
    pass(io, preview.summary);
}

template <class Frame>
QByteArray written(const Frame& frame) {
    QByteArray bytes;
    Put put(bytes);
    put(version);
    pass(put, frame);
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
    pass(take, frame);
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
