// A robot for the tests of the plan editor, which the courier's plan fits.
#pragma once

#include <vector>

#include <QPlainTextEdit>

#include "core/agent/posh/posh_primitive.h"
#include "tests/widgets/plan_samples.h"

namespace usar {

inline std::vector<agent::PrimitiveDescription> courierPrimitives() {
    using agent::AnswerType;
    using agent::PoshParameter;
    using agent::PrimitiveKind;
    std::vector<agent::PrimitiveDescription> all;
    const auto sense = [&all](const char* name, AnswerType answer) {
        all.push_back({name, PrimitiveKind::Sense, {}, answer, {}, "Asks.", {}});
    };
    sense("Loaded", AnswerType::Boolean);
    sense("Bumped", AnswerType::Boolean);
    sense("Rested", AnswerType::Boolean);
    sense("Delivered", AnswerType::Boolean);
    sense("Distance", AnswerType::Real);
    sense("Battery", AnswerType::Real);
    for (const char* const name : {"CloseGripper", "Beep", "Slow", "Stop", "Brake", "Rest"})
        all.push_back({name, PrimitiveKind::Act, {}, AnswerType::Any, {}, "Does it.", {}});
    all.push_back({"DriveTo",
                   PrimitiveKind::Act,
                   {PoshParameter::text("goal", "home"), PoshParameter::number("speed", 1.0, "m/s", 0.0, 3.0)},
                   AnswerType::Any,
                   {},
                   "Drives to a place.",
                   {}});
    return all;
}

/// Puts the cursor before this character of a text that is ASCII.
inline void putCursor(QPlainTextEdit& edit, std::size_t place) {
    QTextCursor cursor = edit.textCursor();
    cursor.setPosition(static_cast<int>(place));
    edit.setTextCursor(cursor);
}

} // namespace usar
