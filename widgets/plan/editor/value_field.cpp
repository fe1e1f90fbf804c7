#include "widgets/plan/editor/value_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <QHBoxLayout>

#include "core/posh/language/plan_reader.h"
#include "core/posh/model/literal.h"

namespace usar::widgets {

using agent::AnswerType;

namespace {

constexpr double any_number = 1e9;
constexpr int plan_decimals = 4;

AnswerType planTypeOf(const posh::Value& value) {
    constexpr std::array types{AnswerType::Any,  AnswerType::Boolean, AnswerType::Integer,
                               AnswerType::Real, AnswerType::Text,    AnswerType::Symbol};
    return types[value.index()];
}

double planNumberIn(const posh::Value& value) {
    const auto* const whole = std::get_if<std::int64_t>(&value);
    const auto* const real = std::get_if<double>(&value);
    return real ? *real : whole ? static_cast<double>(*whole) : 0.0;
}

/// True if the editor for that shape can show the value.
bool fitsShape(const ValueShape& shape, const posh::Value& value) {
    const AnswerType type = planTypeOf(value);
    const bool is_number = type == AnswerType::Integer || type == AnswerType::Real;
    if (shape.type == AnswerType::Real && is_number)
        return std::abs(planNumberIn(value)) < any_number;
    if (shape.type == AnswerType::Integer && type == AnswerType::Integer)
        return std::abs(planNumberIn(value)) < any_number;
    if (shape.type == AnswerType::Symbol && type == AnswerType::Symbol)
        return std::ranges::count(shape.choices, std::get<posh::Symbol>(value).text) > 0;
    return shape.type == AnswerType::Boolean && type == AnswerType::Boolean;
}

posh::Literal literalOf(posh::Value value) {
    std::string spelling = posh::spelled(value);
    return {std::move(value), std::move(spelling), {}};
}

QString spellingOf(const PlanValue& value) {
    if (const auto* const variable = std::get_if<posh::Variable>(&value))
        return '$' + QString::fromStdString(variable->name);
    const auto& literal = std::get<posh::Literal>(value);
    return QString::fromStdString(literal.spelling.empty() ? posh::spelled(literal.value) : literal.spelling);
}

} // namespace

ValueShape shapeOf(const agent::PoshParameter& parameter) {
    return {planTypeOf(parameter.default_value), QString::fromStdString(parameter.unit), parameter.minimum,
            parameter.maximum, parameter.choices};
}

ValueShape shapeOf(const agent::PrimitiveDescription& sense) {
    return {sense.answer, QString::fromStdString(sense.unit), sense.minimum, sense.maximum, sense.choices};
}

ValueField::ValueField(const ValueShape& shape, const PlanValue& value, const QString& name, QWidget* parent)
    : QWidget(parent)
    , first_(value)
    , type_(shape.type) {
    QWidget* const editor = makeEditor(shape);
    editor->setAccessibleName(name);
    editor->setMinimumWidth(160);
    setFocusProxy(editor);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(editor);
}

QWidget* ValueField::makeEditor(const ValueShape& shape) {
    const auto* const literal = std::get_if<posh::Literal>(&first_);
    if (!literal || !fitsShape(shape, literal->value))
        return makeWords();
    if (type_ == AnswerType::Boolean)
        return makeChoice({"true", "false"}, std::get<bool>(literal->value) ? "true" : "false");
    if (type_ == AnswerType::Symbol)
        return makeChoice(shape.choices, std::get<posh::Symbol>(literal->value).text);
    return makeNumber(shape, planNumberIn(literal->value));
}

QWidget* ValueField::makeChoice(const std::vector<std::string>& choices, const std::string& chosen) {
    choice_ = new QComboBox(this);
    for (const std::string& choice : choices)
        choice_->addItem(QString::fromStdString(choice));
    choice_->setCurrentText(QString::fromStdString(chosen));
    connect(choice_, &QComboBox::currentIndexChanged, this, &ValueField::changed);
    return choice_;
}

QWidget* ValueField::makeNumber(const ValueShape& shape, double number) {
    const bool has_range = shape.minimum != 0.0 || shape.maximum != 0.0;
    const double low = std::min(number, has_range ? shape.minimum : -any_number);
    const double high = std::max(number, has_range ? shape.maximum : any_number);
    const QString suffix = shape.unit.isEmpty() ? QString() : QChar(0x00a0) + shape.unit;
    if (type_ == AnswerType::Integer) {
        whole_ = new QSpinBox(this);
        whole_->setRange(static_cast<int>(low), static_cast<int>(high));
        whole_->setSuffix(suffix);
        whole_->setValue(static_cast<int>(number));
        connect(whole_, &QSpinBox::valueChanged, this, &ValueField::changed);
        return whole_;
    }
    number_ = new QuantityBox(this);
    number_->setDecimals(plan_decimals);
    number_->setRange(low, high);
    number_->setSingleStep(has_range && high - low <= 2.0 ? 0.05 : 0.5);
    number_->setSuffix(suffix);
    number_->setValue(number);
    connect(number_, &QDoubleSpinBox::valueChanged, this, &ValueField::changed);
    return number_;
}

QWidget* ValueField::makeWords() {
    words_ = new QLineEdit(spellingOf(first_), this);
    words_->setPlaceholderText(tr("true, 0.3, 'high, \"text\" or $parameter"));
    connect(words_, &QLineEdit::textChanged, this, &ValueField::changed);
    return words_;
}

std::optional<PlanValue> ValueField::edited() const {
    if (choice_ && type_ == AnswerType::Boolean)
        return literalOf(choice_->currentIndex() == 0);
    if (choice_)
        return literalOf(posh::Symbol{choice_->currentText().toStdString()});
    if (whole_)
        return literalOf(static_cast<std::int64_t>(whole_->value()));
    if (number_)
        return literalOf(number_->value());
    const std::string words = words_->text().trimmed().toStdString();
    if (words.starts_with('$') && words.size() > 1)
        return posh::Variable{words.substr(1), {}};
    if (auto value = posh::readValue(words))
        return posh::Literal{*std::move(value), words, {}};
    return std::nullopt;
}

std::optional<PlanValue> ValueField::value() const {
    std::optional<PlanValue> now = edited();
    const auto* const was = std::get_if<posh::Literal>(&first_);
    const auto* const is = now ? std::get_if<posh::Literal>(&*now) : nullptr;
    const bool is_same =
        was && is && (was->value == is->value || (number_ && planNumberIn(was->value) == number_->value()));
    return is_same ? first_ : now;
}

} // namespace usar::widgets
