// How a robot registers its senses and acts for plans: functions and classes of C++ become primitives.
#pragma once

#include <concepts>
#include <initializer_list>
#include <type_traits>

#include "core/agent/posh_registry.h"

namespace usar::agent {

/// Adds senses and acts for robots whose body is a `Body` to a registry, which must outlive this object.
template <std::derived_from<PoshBody> Body>
class PoshPrimitives {
public:
    /// Holds only a reference, so it may be made, used and thrown away.
    explicit PoshPrimitives(PoshRegistry& registry) : registry_(registry) {}

    /// `ask` is called as `ask(const Body&, const PoshArguments&)` or `ask(const Body&)` and returns a bool, a number,
    /// a text, a symbol or a Value.
    template <class Ask>
    PoshRegistry::Entry sense(std::string name, Ask ask) {
        using Answer = decltype(call(ask, std::declval<const Body&>(), std::declval<const PoshArguments&>()));
        PoshPrimitive primitive = named(std::move(name), PrimitiveKind::Sense);
        primitive.description.answer = answerType<Answer>();
        primitive.sense = [ask = std::move(ask)](const PoshBody& body, const PoshArguments& arguments,
                                                 posh::Value& answer) {
            if constexpr (answerType<Answer>() == AnswerType::Integer)
                answer = static_cast<std::int64_t>(call(ask, static_cast<const Body&>(body), arguments));
            else
                answer = call(ask, static_cast<const Body&>(body), arguments);
        };
        return registry_.add(std::move(primitive));
    }

    /// An act that is done in one call: `code(Body&, const PoshArguments&)` or `code(Body&)`. It returns an ActResult;
    /// a result of true or void means RunningOnce, false means Failed.
    /// Each call of the act in a plan has a copy of `code` with a state of its own.
    template <class Code>
    PoshRegistry::Entry act(std::string name, Code code) {
        PoshPrimitive primitive = named(std::move(name), PrimitiveKind::Act);
        primitive.make_act = [code = std::move(code)] { return std::make_unique<ActOf<Code>>(code); };
        return registry_.add(std::move(primitive));
    }

    /// An act of class `Act`, which has `ActResult run(Body&, const PoshArguments&)` and, optionally, `init` with the
    /// same parameters and `done` with an additional DoneReason.
    /// `Act` must be copyable: each call of the act in a plan gets a copy of its own.
    template <std::default_initializable Act>
    PoshRegistry::Entry act(std::string name) {
        return act(std::move(name), Act());
    }

private:
    /// Calls with the arguments if the function takes them, and otherwise with the body alone.
    template <class Function, class AnyBody>
    static auto call(Function& function, AnyBody& body, const PoshArguments& arguments) {
        if constexpr (std::is_invocable_v<Function&, AnyBody&, const PoshArguments&>)
            return function(body, arguments);
        else
            return function(body);
    }

    /// The type of a sense's answer follows from the return type; anything unusual is Any and must be a Value.
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
        else
            return std::is_same_v<Answer, posh::Symbol> ? AnswerType::Symbol : AnswerType::Any;
    }

    /// A primitive without code yet.
    static PoshPrimitive named(std::string name, PrimitiveKind kind) {
        PoshPrimitive primitive;
        primitive.description.name = std::move(name);
        primitive.description.kind = kind;
        return primitive;
    }

    /// One call of an act in a plan, with a copy of its code: a class with `run`, or a function.
    template <class Code>
    class ActOf final : public PoshAct {
    public:
        explicit ActOf(Code code) : code_(std::move(code)) {}
        /// Does nothing if the code has no `init`. The body is always the `Body` that the registry was made for.
        void init(PoshBody& body, const PoshArguments& arguments) override {
            if constexpr (requires { code_.init(static_cast<Body&>(body), arguments); })
                code_.init(static_cast<Body&>(body), arguments);
        }
        /// Prefers `run` of a class to a call of the object, and turns the result into an ActResult.
        posh::ActResult run(PoshBody& any_body, const PoshArguments& arguments) override {
            using posh::ActResult;
            auto& body = static_cast<Body&>(any_body);
            if constexpr (requires { code_.run(body, arguments); }) {
                return code_.run(body, arguments);
            } else if constexpr (std::is_same_v<decltype(call(code_, body, arguments)), bool>) {
                return call(code_, body, arguments) ? ActResult::RunningOnce : ActResult::Failed;
            } else if constexpr (std::is_void_v<decltype(call(code_, body, arguments))>) {
                call(code_, body, arguments);
                return ActResult::RunningOnce;
            } else {
                return call(code_, body, arguments);
            }
        }
        /// Does nothing if the code has no `done`.
        void done(PoshBody& body, const PoshArguments& arguments, posh::DoneReason reason) override {
            if constexpr (requires { code_.done(static_cast<Body&>(body), arguments, reason); })
                code_.done(static_cast<Body&>(body), arguments, reason);
        }

    private:
        Code code_;
    };

    PoshRegistry& registry_;
};

/// The senses and acts that these functions add.
/// The functions are called in order, once each; the registry is complete on return.
template <class Body>
PoshRegistry registryOf(std::initializer_list<void (*)(PoshPrimitives<Body>&)> adders) {
    PoshRegistry registry;
    PoshPrimitives<Body> primitives(registry);
    for (const auto add : adders)
        add(primitives);
    return registry;
}

} // namespace usar::agent
