// Editor for one value of a plan that depends on its type: a switch, a number with unit and range, a choice, or text.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>
#include <QWidget>

#include "core/agent/posh/posh_primitive.h"
#include "widgets/panels/quantity_box.h"

namespace usar::widgets {

/// Type and limits of a value. Numbers are in the plan's units: SI, radians.
struct ValueShape {
    agent::AnswerType type = agent::AnswerType::Any;
    QString unit{};
    double minimum = 0.0; ///< both 0: no range
    double maximum = 0.0;
    std::vector<std::string> choices{};
};
/// The shape of a parameter of a sense or act, from its default, range and choices.
ValueShape shapeOf(const agent::PoshParameter& parameter);
/// The shape of a sense's answer.
ValueShape shapeOf(const agent::PrimitiveDescription& sense);

/// A value in a call: a literal, or a parameter of the enclosing form.
using PlanValue = std::variant<posh::Literal, posh::Variable>;

/// An unchanged value keeps its spelling. A parameter (`$speed`), or a value that does not fit the shape, is edited as
/// text. GUI thread.
class ValueField : public QWidget {
    Q_OBJECT
public:
    /// `name` is the accessible name of the editor.
    ValueField(const ValueShape& shape, const PlanValue& value, const QString& name, QWidget* parent);

    /// The edited value; nullopt while the text is not a value.
    std::optional<PlanValue> value() const;

signals:
    /// The user edited the value; value() may be nullopt.
    void changed();

private:
    /// These make the editor and set `edited_`.
    QWidget* makeEditor(const ValueShape& shape);
    QWidget* makeChoice(const std::vector<std::string>& choices, const std::string& chosen);
    QWidget* makeNumber(const ValueShape& shape, double number);
    QWidget* makeWords();

    PlanValue first_;
    agent::AnswerType type_;
    std::function<std::optional<PlanValue>()> edited_; ///< reads the editor; nullopt while its text is not a value
};

} // namespace usar::widgets
