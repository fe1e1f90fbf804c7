#include "widgets/plan/editor/plan_values_dialog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/posh/edit/plan_phrase.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/model/literal.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

using agent::AnswerType;
using posh::Predicate;

namespace {

constexpr std::array compared_by{Predicate::Equal,       Predicate::NotEqual, Predicate::Less,
                                 Predicate::LessOrEqual, Predicate::Greater,  Predicate::GreaterOrEqual};

/// Returns the initial operand of a new comparison.
posh::Value firstOperand(const ValueShape& shape) {
    switch (shape.type) {
    case AnswerType::Boolean:
        return true;
    case AnswerType::Integer:
        return static_cast<std::int64_t>(shape.minimum);
    case AnswerType::Text:
        return std::string();
    case AnswerType::Symbol:
        return posh::Symbol{shape.choices.empty() ? "value" : shape.choices.front()};
    default:
        return shape.minimum;
    }
}

constexpr double any_number = 1e9;
constexpr int plan_decimals = 4;

AnswerType planTypeOf(const posh::Value& value) {
    constexpr std::array types{AnswerType::Any,  AnswerType::Boolean, AnswerType::Integer,
                               AnswerType::Real, AnswerType::Text,    AnswerType::Symbol};
    return types[value.index()];
}

/// True if the editor for that shape can show the value.
bool fitsShape(const ValueShape& shape, const posh::Value& value) {
    const AnswerType type = planTypeOf(value);
    if (shape.type == AnswerType::Integer || shape.type == AnswerType::Real)
        return (type == shape.type || type == AnswerType::Integer) && std::abs(posh::numberOf(value)) < any_number;
    if (shape.type == AnswerType::Symbol && type == AnswerType::Symbol)
        return std::ranges::count(shape.choices, std::get<posh::Symbol>(value).text) > 0;
    return shape.type == AnswerType::Boolean && type == AnswerType::Boolean;
}

PlanValue literalOf(const posh::Value& value) {
    return posh::Literal{value, posh::spelled(value), {}};
}

QString spellingOf(const PlanValue& value) {
    if (const auto* const variable = std::get_if<posh::Variable>(&value))
        return '$' + QString::fromStdString(variable->name);
    const auto& literal = std::get<posh::Literal>(value);
    return QString::fromStdString(literal.spelling.empty() ? posh::spelled(literal.value) : literal.spelling);
}

/// Returns the shape of a parameter of a sense or act, from its default, range and choices.
ValueShape shapeOf(const agent::PoshParameter& parameter) {
    return {planTypeOf(parameter.default_value), QString::fromStdString(parameter.unit), parameter.minimum,
            parameter.maximum, parameter.choices};
}

/// Returns the shape of a sense's answer.
ValueShape shapeOf(const agent::PrimitiveDescription& sense) {
    return {sense.answer, QString::fromStdString(sense.unit), sense.minimum, sense.maximum, sense.choices};
}

} // namespace

ValueField::ValueField(const ValueShape& shape, const PlanValue& value, const QString& name, QWidget* parent)
    : QWidget(parent)
    , first_(value)
    , type_(shape.type) {
    const auto* const literal = std::get_if<posh::Literal>(&first_);
    QWidget* editor = nullptr;
    if (!literal || !fitsShape(shape, literal->value))
        editor = makeWords();
    else if (type_ == AnswerType::Boolean)
        editor = makeChoice({"true", "false"}, std::get<bool>(literal->value) ? "true" : "false");
    else if (type_ == AnswerType::Symbol)
        editor = makeChoice(shape.choices, std::get<posh::Symbol>(literal->value).text);
    else
        editor = makeNumber(shape, posh::numberOf(literal->value));
    editor->setAccessibleName(name);
    editor->setMinimumWidth(160);
    setFocusProxy(editor);
    laidOut(new QHBoxLayout(this), {}, 0, {editor});
}

QWidget* ValueField::makeChoice(const std::vector<std::string>& choices, const std::string& chosen) {
    auto* const box = new QComboBox(this);
    for (const std::string& choice : choices)
        box->addItem(QString::fromStdString(choice));
    box->setCurrentText(QString::fromStdString(chosen));
    connect(box, &QComboBox::currentIndexChanged, this, &ValueField::changed);
    edited_ = [this, box] {
        return type_ == AnswerType::Boolean ? literalOf(box->currentIndex() == 0)
                                            : literalOf(posh::Symbol{box->currentText().toStdString()});
    };
    return box;
}

QWidget* ValueField::makeNumber(const ValueShape& shape, double number) {
    const bool has_range = shape.minimum != 0.0 || shape.maximum != 0.0;
    const double low = std::min(number, has_range ? shape.minimum : -any_number);
    const double high = std::max(number, has_range ? shape.maximum : any_number);
    const QString suffix = shape.unit.isEmpty() ? QString() : QChar(0x00a0) + shape.unit;
    if (type_ == AnswerType::Integer) {
        auto* const box = new QSpinBox(this);
        box->setRange(static_cast<int>(low), static_cast<int>(high));
        box->setSuffix(suffix);
        tellRange(box, tr("A whole number"));
        box->setValue(static_cast<int>(number));
        connect(box, &QSpinBox::valueChanged, this, &ValueField::changed);
        edited_ = [box] { return literalOf(static_cast<std::int64_t>(box->value())); };
        return box;
    }
    auto* const box = new QuantityBox(this);
    box->setDecimals(plan_decimals);
    box->setRange(low, high);
    box->setSingleStep(has_range && high - low <= 2.0 ? 0.05 : 0.5);
    box->setSuffix(suffix);
    tellRange(box, tr("A number"));
    box->setValue(number);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ValueField::changed);
    edited_ = [this, box, number] { return number == box->value() ? first_ : literalOf(box->value()); };
    return box;
}

QWidget* ValueField::makeWords() {
    auto* const line = new QLineEdit(spellingOf(first_), this);
    line->setPlaceholderText(tr("true, 0.3, 'high, \"text\" or $parameter"));
    connect(line, &QLineEdit::textChanged, this, &ValueField::changed);
    edited_ = [line]() -> std::optional<PlanValue> {
        const std::string words = line->text().trimmed().toStdString();
        if (words.starts_with('$') && words.size() > 1)
            return posh::Variable{words.substr(1), {}};
        if (auto value = posh::readValue(words))
            return posh::Literal{*std::move(value), words, {}};
        return std::nullopt;
    };
    return line;
}

std::optional<PlanValue> ValueField::value() const {
    std::optional<PlanValue> now = edited_();
    const auto* const was = std::get_if<posh::Literal>(&first_);
    const auto* const is = now ? std::get_if<posh::Literal>(&*now) : nullptr;
    return was && is && was->value == is->value ? first_ : now;
}

PlanValuesDialog::PlanValuesDialog(agent::PrimitiveDescription description, const posh::Step& step, QWidget* parent)
    : QDialog(parent)
    , description_(std::move(description))
    , form_(laidOut(new QFormLayout(this), gap::small)) {
    const auto* const test = std::get_if<posh::SenseTest>(&step);
    first_ = test ? *test : posh::SenseTest{std::get<posh::Call>(step), {}, {}};
    addHead();
    addArguments();
    if (test)
        addComparison();
    else if (arguments_.empty())
        form_->addRow(new QLabel(tr("It takes no values."), this));
    addEnd();
}

void PlanValuesDialog::addHead() {
    setWindowTitle(tr("Values"));
    form_->addRow(makeLabel(this, "title", QString::fromStdString(first_.call.name.text)));
    if (description_.help.empty())
        return;
    auto* const help = makeLabel(this, "muted", QString::fromStdString(description_.help));
    help->setMinimumWidth(340);
    form_->addRow(help);
}

/// Adds the declared parameters in their order, then the other arguments of the call.
void PlanValuesDialog::addArguments() {
    const std::vector<posh::Argument>& given = first_.call.arguments;
    std::vector<bool> is_shown(given.size(), false);
    for (std::size_t i = 0; i < description_.parameters.size(); ++i) {
        const agent::PoshParameter& parameter = description_.parameters[i];
        ArgumentRow row{.argument = std::nullopt, .parameter = &parameter};
        for (std::size_t k = 0; k < given.size(); ++k)
            if (given[k].name.empty() ? k == i : given[k].name == parameter.name)
                row.argument = k;
        if (row.argument)
            is_shown[*row.argument] = true;
        const PlanValue value =
            row.argument ? given[*row.argument].value : posh::Literal{parameter.default_value, {}, {}};
        const QString name = QString::fromStdString(parameter.name);
        row.field = new ValueField(shapeOf(parameter), value, name, this);
        row.field->setToolTip(QString::fromStdString(parameter.help + (parameter.help.empty() ? "" : " ") + '(' +
                                                     agent::typeText(parameter) + ')'));
        form_->addRow(name, row.field);
        arguments_.push_back(row);
    }
    for (std::size_t k = 0; k < given.size(); ++k) {
        if (is_shown[k])
            continue;
        const QString name =
            given[k].name.empty() ? tr("Argument %1").arg(k + 1) : QString::fromStdString(given[k].name);
        arguments_.push_back({k, nullptr, new ValueField({}, given[k].value, name, this)});
        form_->addRow(name, arguments_.back().field);
    }
}

void PlanValuesDialog::addComparison() {
    comparison_ = new QComboBox(this);
    comparison_->setAccessibleName(tr("Its answer"));
    comparison_->addItem(description_.answer == AnswerType::Boolean ? tr("is true")
                                                                    : tr("holds (is not 0, not empty)"));
    comparison_->addItems(
        {"=  (equals)", "≠  (differs from)", "<  (less than)", "≤  (at most)", ">  (more than)", "≥  (at least)"});
    const ValueShape shape = shapeOf(description_);
    const posh::Literal operand = first_.operand.value_or(posh::Literal{firstOperand(shape), {}, {}});
    operand_ = new ValueField(shape, operand, tr("Value"), this);
    if (first_.operand) {
        const auto found = std::ranges::find(compared_by, first_.predicate.value_or(Predicate::Equal));
        comparison_->setCurrentIndex(static_cast<int>(found - compared_by.begin()) + 1);
    }
    form_->addRow(tr("Its &answer"), comparison_);
    form_->addRow(tr("&Value"), operand_);
    connect(comparison_, &QComboBox::currentIndexChanged, this, &PlanValuesDialog::check);
    connect(operand_, &ValueField::changed, this, &PlanValuesDialog::check);
}

void PlanValuesDialog::addEnd() {
    phrase_ = makeLabel(this);
    phrase_->setAccessibleName(tr("As the plan writes it"));
    form_->addRow(phrase_);
    ok_ = addDialogButtons(form_);
    for (const ArgumentRow& row : arguments_)
        connect(row.field, &ValueField::changed, this, &PlanValuesDialog::check);
    check();
    if (operand_ && operand_->isEnabled())
        operand_->setFocus();
}

posh::SenseTest PlanValuesDialog::test() const {
    posh::SenseTest test = first_;
    for (const ArgumentRow& row : arguments_) {
        const auto value = row.field->value();
        if (!value)
            continue;
        if (row.argument)
            test.call.arguments[*row.argument].value = *value;
        else if (*value != PlanValue(posh::Literal{row.parameter->default_value, {}, {}}))
            test.call.arguments.push_back({row.parameter->name, *value, {}});
    }
    if (!comparison_)
        return test;
    const int chosen = comparison_->currentIndex();
    const auto operand = operand_->value();
    const auto* const literal = operand ? std::get_if<posh::Literal>(&*operand) : nullptr;
    if (chosen == 0)
        test.operand.reset();
    else if (literal)
        test.operand = *literal;
    const bool stays_bare = first_.operand && !first_.predicate && chosen == 1;
    test.predicate =
        chosen == 0 || stays_bare ? std::nullopt : std::optional(compared_by[static_cast<std::size_t>(chosen) - 1]);
    return test;
}

void PlanValuesDialog::check() {
    bool fine = true;
    for (const ArgumentRow& row : arguments_)
        fine = fine && row.field->value();
    if (comparison_) {
        operand_->setEnabled(comparison_->currentIndex() > 0);
        const auto operand = operand_->value();
        fine = fine && (!operand_->isEnabled() || (operand && std::holds_alternative<posh::Literal>(*operand)));
    }
    phrase_->setText(fine ? QString::fromStdString(posh::phraseOf(test()))
                          : tr("This is not a value. Write true, false, a number, 'a-symbol or \"a text\"."));
    setRole(phrase_, fine ? "muted" : "danger");
    ok_->setEnabled(fine);
}

} // namespace usar::widgets
