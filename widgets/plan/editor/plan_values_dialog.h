// Dialog for the values in a sense or a call of a plan: arguments by type and range, and the comparison of the answer.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
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

/// A value in a call: a literal, or a parameter of the enclosing form.
using PlanValue = std::variant<posh::Literal, posh::Variable>;

/// Editor for one value that depends on its type: a switch, a number with unit and range, a choice, or text. An
/// unchanged value keeps its spelling. A parameter (`$speed`), or a value that does not fit the shape, is edited as
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
    QWidget* makeChoice(const std::vector<std::string>& choices, const std::string& chosen);
    QWidget* makeNumber(const ValueShape& shape, double number);
    QWidget* makeWords();

    PlanValue first_;
    agent::AnswerType type_;
    std::function<std::optional<PlanValue>()> edited_; ///< reads the editor; nullopt while its text is not a value
};

/// Accepts only values that a plan can contain. Arguments that the robot does not describe are edited as text. GUI
/// thread.
class PlanValuesDialog : public QDialog {
    Q_OBJECT
public:
    /// For a sense it includes the comparison. `description` is that of the sense, act or form which `step` calls.
    PlanValuesDialog(agent::PrimitiveDescription description, const posh::Step& step, QWidget* parent);

    /// The call as edited so far.
    posh::Call call() const { return test().call; }
    /// The test as edited so far; without comparison in a dialog for an act.
    posh::SenseTest test() const;

private:
    struct ArgumentRow {
        std::optional<std::size_t> argument; ///< index in the call; nullopt: the call uses the default
        const agent::PoshParameter* parameter = nullptr;
        ValueField* field = nullptr;
    };
    /// The following add the parts of the form from top to bottom.
    void addHead();
    void addArguments();
    void addComparison();
    void addEnd();
    /// Shows the resulting phrase and enables OK if all values are valid.
    void check();

    agent::PrimitiveDescription description_;
    posh::SenseTest first_;
    QFormLayout* form_;
    std::vector<ArgumentRow> arguments_;
    QComboBox* comparison_ = nullptr; ///< senses only
    ValueField* operand_ = nullptr;
    QLabel* phrase_ = nullptr;
    QPushButton* ok_ = nullptr;
};

} // namespace usar::widgets
