#include "core/campaign/plan/campaign_choices.h"

#include <algorithm>
#include <cmath>

#include <QRegularExpression>
#include <QStringList>

#include "core/base/numbers.h"

namespace usar::campaign {

namespace {

std::string nameOfVariant(const ChosenBehavior& behavior, const CampaignChoices& choices) {
    const auto same = std::ranges::count(choices.behaviors, behavior.title, &ChosenBehavior::title);
    return same > 1 ? behavior.title + " (" + behavior.id + ')' : behavior.title;
}

QString withoutUnit(const QString& word, const QString& unit) {
    return !unit.isEmpty() && word.endsWith(unit) ? word.chopped(unit.size()) : word;
}

} // namespace

Campaign campaignOf(const CampaignChoices& choices) {
    Campaign campaign;
    campaign.name = choices.name;
    campaign.missions.push_back({choices.mission_file, choices.first_seed, choices.seeds, {}, {}});
    campaign.faults = choices.faults;
    campaign.swarm = choices.swarm;
    for (const ChosenBehavior& behavior : choices.behaviors) {
        const Variant usual{nameOfVariant(behavior, choices), behavior.id, behavior.plan, behavior.values};
        if (choices.parameter.empty() || choices.values.empty())
            campaign.variants.push_back(usual);
        for (const double value : choices.parameter.empty() ? std::vector<double>() : choices.values) {
            Variant variant = usual;
            const std::string number = shortest(value);
            variant.name += ", " + choices.parameter_title + ' ' + number;
            std::erase_if(variant.values,
                          [&](const std::string& one) { return one.starts_with(choices.parameter + '='); });
            variant.values.push_back(choices.parameter + '=' + number);
            campaign.variants.push_back(std::move(variant));
        }
    }
    return campaign;
}

Result<std::vector<double>> readValues(const QString& text, const ValueWords& known) {
    static const QRegularExpression gaps("[\\s,;]+", QRegularExpression::UseUnicodePropertiesOption);
    QString plain = text;
    if (!known.words.isEmpty())
        plain.replace(known.words, QString::fromStdString(shortest(known.value)), Qt::CaseInsensitive);
    std::vector<double> values;
    for (const QString& word : plain.split(gaps, Qt::SkipEmptyParts)) {
        if (!known.unit.isEmpty() && word == known.unit && !values.empty())
            continue;
        const auto value = readNumber(withoutUnit(word, known.unit).toStdString());
        if (!value || !std::isfinite(*value))
            return failure("this is no number", word.toStdString(), "Write the values as 3, 4.5, 6");
        if (std::ranges::find(values, *value) != values.end())
            return failure("this value is there twice", word.toStdString(), "Leave one of them out");
        values.push_back(*value);
    }
    return values;
}

} // namespace usar::campaign
