// One value of a plan, edited as its type wants it: a switch, a number with its unit and range, a choice, or words.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>
#include <QWidget>

#include "core/agent/posh_primitive.h"
#include "widgets/quantity_box.h"

namespace usar::widgets {

/// What a value should be. Numbers are in the plan's units: SI, radians.
struct ValueShape {
    agent::AnswerType type = agent::AnswerType::Any;
    QString unit{};
    double minimum = 0.0; ///< both 0: no range
    double maximum = 0.0;
    std::vector<std::string> choices{};
};
ValueShape shapeOf(const agent::PoshParameter& parameter);
/// Of a sense's answer.
ValueShape shapeOf(const agent::PrimitiveDescription& sense);

/// A value as a call has it: a literal, or a parameter of the form around it.
using PlanValue = std::variant<posh::Literal, posh::Variable>;

/// What is not touched keeps its spelling. A parameter (`$speed`), or a value that is none of the shape, is edited as
/// words. GUI thread.
class ValueField : public QWidget {
    Q_OBJECT
public:
    ValueField(const ValueShape& shape, const PlanValue& value, const QString& name, QWidget* parent);

    /// Nothing while what is typed is no value.
    std::optional<PlanValue> value() const;

signals:
    void changed();

private:
    QWidget* makeEditor(const ValueShape& shape);
    QWidget* makeChoice(const std::vector<std::string>& choices, const std::string& chosen);
    QWidget* makeNumber(const ValueShape& shape, double number);
    QWidget* makeWords();
    std::optional<PlanValue> edited() const;

    PlanValue first_;
    agent::AnswerType type_;
    QComboBox* choice_ = nullptr; ///< one of these four is there
    QSpinBox* whole_ = nullptr;
    QuantityBox* number_ = nullptr;
    QLineEdit* words_ = nullptr;
};

} // namespace usar::widgets
