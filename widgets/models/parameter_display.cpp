#include "widgets/models/parameter_display.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <QCoreApplication>
#include <QStringList>

#include "core/base/geometry.h"
#include "core/base/numbers.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("ParameterForm", text);
}

constexpr int most_decimals = 6;

/// Returns the fewest decimals that show `value` to nine significant digits, at most six.
int decimalsOf(double value) {
    double scale = 1.0;
    for (int decimals = 0; decimals < most_decimals; ++decimals, scale *= 10.0)
        if (std::abs(value * scale - std::round(value * scale)) <= 1e-9 * std::max(1.0, std::abs(value * scale)))
            return decimals;
    return most_decimals;
}

/// The same for a value in the unit that people read. A round figure in radians is endless in degrees: two decimals say
/// enough of it, and the parameter itself keeps its exact value until it is edited.
int decimalsShown(double shown, const DisplayUnit& unit) {
    const int decimals = decimalsOf(shown);
    return decimals == most_decimals && unit.factor != 1.0 ? 2 : decimals;
}

QString withUnit(const QString& number, const QString& unit) {
    return unit.isEmpty() ? number : number + QChar(0x00a0) + unit;
}

QString numberText(double si, const agent::ParameterSpec& spec) {
    const DisplayUnit unit = displayUnit(spec.unit);
    const double shown = si * unit.factor;
    return withUnit(QString::fromStdString(fixed(shown, decimalsShown(shown, unit))), unit.text);
}

} // namespace

DisplayUnit displayUnit(const std::string& unit) {
    constexpr double degrees = 180.0 / pi;
    static const std::map<std::string, DisplayUnit> others = {{"rad", {QStringLiteral("°"), degrees}},
                                                              {"rad/s", {QStringLiteral("°/s"), degrees}},
                                                              {"rad/s2", {QStringLiteral("°/s²"), degrees}},
                                                              {"m/s2", {QStringLiteral("m/s²"), 1.0}}};
    const auto found = others.find(unit);
    return found != others.end() ? found->second : DisplayUnit{QString::fromStdString(unit), 1.0};
}

int decimalsFor(const agent::ParameterSpec& spec) {
    const auto* value = std::get_if<double>(&spec.default_value);
    if (!value)
        return 0;
    const DisplayUnit unit = displayUnit(spec.unit);
    const double span = (spec.maximum - spec.minimum) * unit.factor;
    const int by_span = span >= 100.0 ? 1 : span >= 10.0 ? 2 : 3;
    return std::max(by_span, decimalsShown(*value * unit.factor, unit));
}

double stepFor(const agent::ParameterSpec& spec) {
    const double span = (spec.maximum - spec.minimum) * displayUnit(spec.unit).factor;
    if (!std::isfinite(span) || span <= 0.0)
        return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(span / 50.0)));
    const double lead = span / 50.0 / power;
    const double step = power * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
    return std::holds_alternative<long long>(spec.default_value) ? std::max(1.0, std::round(step)) : step;
}

QString valueText(const agent::ParameterSpec& spec, const agent::ParameterValue& value) {
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? tr("yes") : tr("no");
    const auto* integer = std::get_if<long long>(&value);
    const auto* real = std::get_if<double>(&value);
    if (!integer && !real)
        return QString::fromStdString(std::get<std::string>(value));
    const double number = integer ? static_cast<double>(*integer) : *real;
    if (number == spec.minimum && !spec.minimum_words.empty())
        return QString::fromStdString(spec.minimum_words);
    return numberText(number, spec);
}

QString parameterToolTip(const agent::ParameterSpec& spec) {
    QStringList lines;
    lines << QStringLiteral("<b>%1</b>").arg(QString::fromStdString(spec.label).toHtmlEscaped());
    if (!spec.help.empty())
        lines << QString::fromStdString(spec.help).toHtmlEscaped();
    const QString unit = displayUnit(spec.unit).text;
    if (!unit.isEmpty())
        lines << tr("Unit: %1").arg(unit.toHtmlEscaped());
    const bool number = spec.default_value.index() == 1 || spec.default_value.index() == 2;
    if (number)
        lines << rangeText(numberText(spec.minimum, spec), numberText(spec.maximum, spec)).toHtmlEscaped();
    lines << tr("Default: %1").arg(valueText(spec, spec.default_value).toHtmlEscaped());
    lines << tr("In files: %1").arg(QString::fromStdString(spec.id).toHtmlEscaped());
    return lines.join(QStringLiteral("<br>"));
}

agent::ParameterValue fitted(const agent::ParameterSpec& spec, const agent::ParameterValue& value) {
    agent::ParameterValue result = value;
    const auto* integer = std::get_if<long long>(&value);
    if (integer && std::holds_alternative<double>(spec.default_value))
        result = static_cast<double>(*integer);
    const auto made = agent::ParameterSet::make({spec}, {{spec.id, result}});
    return made ? made->values().at(spec.id) : spec.default_value;
}

bool sameValue(const agent::ParameterValue& a, const agent::ParameterValue& b) {
    const auto* x = std::get_if<double>(&a);
    const auto* y = std::get_if<double>(&b);
    if (x && y)
        return std::abs(*x - *y) <= 1e-9 * std::max({1.0, std::abs(*x), std::abs(*y)});
    return a == b;
}

} // namespace usar::widgets
