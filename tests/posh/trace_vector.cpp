#include "tests/posh/trace_vector.h"

#include <stdexcept>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/engine.h"
#include "tests/doubles/trace_text.h"

using namespace usar::posh;

namespace {

Value valueOf(const QJsonValue& json) {
    switch (json.type()) {
    case QJsonValue::Bool:
        return json.toBool();
    case QJsonValue::Double:
        if (json.toVariant().typeId() == QMetaType::LongLong)
            return std::int64_t{json.toInteger()};
        return json.toDouble();
    case QJsonValue::String:
        return json.toString().toStdString();
    default:
        return std::monostate{};
    }
}

Settings settingsOf(const QJsonValue& json) {
    Settings settings;
    const QJsonObject object = json.toObject();
    for (auto it = object.begin(); it != object.end(); ++it)
        settings.emplace_back(it.key().toStdString(), valueOf(it.value()));
    return settings;
}

std::map<std::string, ActResult> resultsOf(const QJsonValue& json) {
    static const std::map<QString, ActResult> words{{"Finished", ActResult::Finished},
                                                    {"RunningOnce", ActResult::RunningOnce},
                                                    {"Running", ActResult::Running},
                                                    {"Failed", ActResult::Failed}};
    std::map<std::string, ActResult> results;
    const QJsonObject object = json.toObject();
    for (auto it = object.begin(); it != object.end(); ++it)
        results[it.key().toStdString()] = words.at(it.value().toString());
    return results;
}

class VectorHost final : public usar::test::StubHost {
public:
    explicit VectorHost(const TraceVector& vector) : vector_(vector) { set(vector.defaults); }
    void begin(const TraceVector::Cycle& cycle) {
        set(cycle.senses);
        clearResults();
        for (const auto& results : {vector_.results, cycle.results})
            for (const auto& [name, result] : results)
                setResult(name, result);
    }
    ActResult run(CallSite site) override {
        if (const auto effect = vector_.effects.find(program().act_calls[site.call].name);
            effect != vector_.effects.end())
            set(effect->second);
        return StubHost::run(site);
    }

private:
    void set(const Settings& settings) {
        for (const auto& [name, value] : settings)
            setSense(name, value);
    }
    const TraceVector& vector_;
};

} // namespace

QStringList traceVectorFiles(const QString& folder) {
    QStringList files;
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.json"}, QDir::Files, QDir::Name))
        files << file.filePath();
    return files;
}

TraceVector readTraceVector(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error("cannot open " + path.toStdString());
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    TraceVector vector;
    vector.plan = json["plan"].toString().toStdString();
    vector.defaults = settingsOf(json["defaults"]);
    vector.results = resultsOf(json["results"]);
    const QJsonObject effects = json["effects"].toObject();
    for (auto it = effects.begin(); it != effects.end(); ++it)
        vector.effects[it.key().toStdString()] = settingsOf(it.value());
    vector.options.most_acts = json["budget"].toInt(16);
    vector.options.on_goal = json["on_goal"].toString() == "hold" ? OnGoal::Hold : OnGoal::Stop;
    for (const QJsonValue& cycle : json["cycles"].toArray())
        vector.cycles.push_back(
            {Milliseconds(cycle["t"].toInteger()), settingsOf(cycle["senses"]), resultsOf(cycle["results"])});
    for (const QJsonValue& line : json["expect"].toArray())
        vector.expected += line.toString().toStdString() + '\n';
    if (vector.cycles.empty() || vector.expected.empty())
        throw std::runtime_error(path.toStdString() + " is no trace vector");
    return vector;
}

std::string runVector(const TraceVector& vector) {
    const PlanReading reading = readPlan(vector.plan);
    if (hasErrors(reading.findings))
        return toText(reading.findings.front());
    const auto program = compile(reading.plan);
    if (!program)
        return program.error().text();
    VectorHost host(vector);
    usar::test::TraceText trace;
    {
        Engine engine(host, *program, vector.options);
        engine.watch(&trace);
        for (const TraceVector::Cycle& cycle : vector.cycles) {
            host.begin(cycle);
            engine.cycle(cycle.time);
        }
        engine.watch(nullptr);
    }
    return trace.text();
}
