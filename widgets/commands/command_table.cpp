#include "widgets/commands/command_table.h"

#include <algorithm>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMetaEnum>

namespace usar::widgets {

extern const char commands_json[];

namespace {

QKeySequence keysOf(const QString& text) {
    const QString prefix = "StandardKey::";
    if (!text.startsWith(prefix))
        return QKeySequence(text, QKeySequence::PortableText);
    const auto standard = QMetaEnum::fromType<QKeySequence::StandardKey>();
    return static_cast<QKeySequence::StandardKey>(standard.keyToValue(text.mid(prefix.size()).toLatin1().constData()));
}

CommandSpec specOf(const QString& id, const QString& group, const QJsonObject& row) {
    CommandSpec spec{id, row["text"].toString(), group, row["help"].toString(), row["icon"].toString(), {}};
    for (const auto& keys : row["keys"].toArray())
        spec.shortcuts << keysOf(keys.toString());
    spec.checkable = row["checkable"].toBool();
    return spec;
}

} // namespace

std::vector<CommandSpec> readCommandTable(const QByteArray& json) {
    std::vector<CommandSpec> table;
    const QJsonObject groups = QJsonDocument::fromJson(json).object();
    for (auto group = groups.begin(); group != groups.end(); ++group) {
        const QJsonObject rows = group->toObject();
        for (auto row = rows.begin(); row != rows.end(); ++row)
            table.push_back(specOf(row.key(), group.key(), row->toObject()));
    }
    return table;
}

const std::vector<CommandSpec>& commandTable() {
    static const std::vector<CommandSpec> table = readCommandTable(commands_json);
    return table;
}

const CommandSpec& commandSpec(const QString& id) {
    const auto found = std::ranges::find(commandTable(), id, &CommandSpec::id);
    Q_ASSERT_X(found != commandTable().end(), "commandSpec", qPrintable(id));
    return *found;
}

} // namespace usar::widgets
