// The senses and acts that a robot offers to plans. It needs no robot, so editors and checks can use it, too.
#pragma once

#include <concepts>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/agent/posh/posh_arguments.h"
#include "core/agent/posh/posh_body.h"

namespace usar::agent {

/// A running act; there is one object for each call in a plan. `init` comes first, `run` once per cycle, `done` last.
class PoshAct {
public:
    virtual ~PoshAct() = default;
    virtual void init(PoshBody&, const PoshArguments&) {}
    virtual posh::ActResult run(PoshBody& body, const PoshArguments& arguments) = 0;
    virtual void done(PoshBody&, const PoshArguments&, posh::DoneReason) {}
};

/// A sense or act: its description and its code.
struct PoshPrimitive {
    PrimitiveDescription description;
    std::function<void(const PoshBody&, const PoshArguments&, posh::Value&)> sense; ///< empty for an act
    std::function<std::unique_ptr<PoshAct>()> make_act;                             ///< empty for a sense
};

/// Senses and acts by name; adding one under an existing name replaces the earlier one.
class PoshRegistry {
public:
    /// Completes the description of the primitive that was just added; valid until the next change of the registry.
    class Entry {
    public:
        explicit Entry(PrimitiveDescription& description) : description_(description) {}
        Entry& describe(std::string help) { return description_.help = std::move(help), *this; }
        Entry& takes(PoshParameter parameter) { return description_.parameters.push_back(std::move(parameter)), *this; }
        Entry& unit(std::string unit) { return description_.unit = std::move(unit), *this; }
        /// The range of a sense's number, inclusive.
        Entry& within(double minimum, double maximum) {
            description_.minimum = minimum;
            description_.maximum = maximum;
            return *this;
        }
        /// The symbols that a sense may answer.
        Entry& oneOf(std::vector<std::string> choices) { return description_.choices = std::move(choices), *this; }
        Entry& needs(std::string sensor_or_command) {
            return description_.needs.push_back(std::move(sensor_or_command)), *this;
        }

    private:
        PrimitiveDescription& description_;
    };

    Entry add(PoshPrimitive primitive);
    const PoshPrimitive* find(std::string_view name) const;
    const std::map<std::string, PoshPrimitive, std::less<>>& all() const { return primitives_; }
    /// Descriptions sorted by name.
    std::vector<PrimitiveDescription> descriptions() const;

private:
    std::map<std::string, PoshPrimitive, std::less<>> primitives_;
};

/// Adds senses and acts for robots whose body is a `Body` to a registry, which must outlive this object.
template <std::derived_from<PoshBody> Body>
class PoshPrimitives {
public:
    explicit PoshPrimitives(PoshRegistry& registry) : registry_(registry) {}

    /// `ask` is called as `ask(const Body&, const PoshArguments&)` or `ask(const Body&)` and returns a bool, a number,
    /// a text, a symbol or a Value.
    template <class Ask>
    PoshRegistry::Entry sense(std::string name, Ask ask) {
        using Answer = decltype(call(ask, std::declval<const Body&>(), std::declval<const PoshArguments&>()));
        PoshPrimitive primitive;
        primitive.description.name = std::move(name);
        primitive.description.kind = PrimitiveKind::Sense;
        primitive.description.answer = answerType<Answer>();
        primitive.sense = [ask = std::move(ask)](const PoshBody& body, const PoshArguments& arguments,
                                                 posh::Value& answer) {
            if constexpr (std::is_integral_v<Answer> && !std::is_same_v<Answer, bool>)
                answer = static_cast<std::int64_t>(call(ask, static_cast<const Body&>(body), arguments));
            else
                answer = call(ask, static_cast<const Body&>(body), arguments);
        };
        return registry_.add(std::move(primitive));
    }

    /// An act that is done in one call: `code(Body&, const PoshArguments&)` or `code(Body&)`. It returns an ActResult;
    /// a result of true or void means RunningOnce, false means Failed.
    template <class Act>
    PoshRegistry::Entry act(std::string name, Act code) {
        PoshPrimitive primitive = actNamed(std::move(name));
        primitive.make_act = [code = std::move(code)] { return std::make_unique<FunctionAct<Act>>(code); };
        return registry_.add(std::move(primitive));
    }

    /// An act of class `Act`, which has `ActResult run(Body&, const PoshArguments&)` and, optionally, `init` with the
    /// same parameters and `done` with an additional DoneReason.
    template <std::default_initializable Act>
    PoshRegistry::Entry act(std::string name) {
        PoshPrimitive primitive = actNamed(std::move(name));
        primitive.make_act = [] { return std::make_unique<ClassAct<Act>>(); };
        return registry_.add(std::move(primitive));
    }

private:
    template <class Function, class AnyBody>
    static auto call(Function& function, AnyBody& body, const PoshArguments& arguments) {
        if constexpr (std::is_invocable_v<Function&, AnyBody&, const PoshArguments&>)
            return function(body, arguments);
        else
            return function(body);
    }

    template <class Answer>
    static constexpr AnswerType answerType() {
        if constexpr (std::is_same_v<Answer, bool>)
            return AnswerType::Boolean;
        else if constexpr (std::is_integral_v<Answer>)
            return AnswerType::Integer;
        else if constexpr (std::is_floating_point_v<Answer>)
            return AnswerType::Real;
        else if constexpr (std::is_same_v<Answer, std::string>)
            return AnswerType::Text;
        else if constexpr (std::is_same_v<Answer, posh::Symbol>)
            return AnswerType::Symbol;
        else
            return AnswerType::Any;
    }

    static PoshPrimitive actNamed(std::string name) {
        PoshPrimitive primitive;
        primitive.description.name = std::move(name);
        primitive.description.kind = PrimitiveKind::Act;
        return primitive;
    }

    template <class Function>
    class FunctionAct final : public PoshAct {
    public:
        explicit FunctionAct(Function function) : function_(std::move(function)) {}
        posh::ActResult run(PoshBody& body, const PoshArguments& arguments) override {
            using Answer = decltype(call(function_, static_cast<Body&>(body), arguments));
            if constexpr (std::is_same_v<Answer, posh::ActResult>) {
                return call(function_, static_cast<Body&>(body), arguments);
            } else if constexpr (std::is_same_v<Answer, bool>) {
                const bool worked = call(function_, static_cast<Body&>(body), arguments);
                return worked ? posh::ActResult::RunningOnce : posh::ActResult::Failed;
            } else {
                static_assert(std::is_void_v<Answer>, "an act answers with an ActResult, a truth value or nothing");
                call(function_, static_cast<Body&>(body), arguments);
                return posh::ActResult::RunningOnce;
            }
        }

    private:
        Function function_;
    };

    template <class Act>
    class ClassAct final : public PoshAct {
    public:
        void init(PoshBody& body, const PoshArguments& arguments) override {
            if constexpr (requires { act_.init(static_cast<Body&>(body), arguments); })
                act_.init(static_cast<Body&>(body), arguments);
        }
        posh::ActResult run(PoshBody& body, const PoshArguments& arguments) override {
            return act_.run(static_cast<Body&>(body), arguments);
        }
        void done(PoshBody& body, const PoshArguments& arguments, posh::DoneReason reason) override {
            if constexpr (requires { act_.done(static_cast<Body&>(body), arguments, reason); })
                act_.done(static_cast<Body&>(body), arguments, reason);
        }

    private:
        Act act_;
    };

    PoshRegistry& registry_;
};

} // namespace usar::agent
