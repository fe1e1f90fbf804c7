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
    return makeNumber(shape, posh::numberOf(literal->value));
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

} // namespace usar::widgets
