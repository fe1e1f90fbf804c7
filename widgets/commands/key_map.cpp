#include "widgets/commands/key_map.h"

#include <algorithm>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace usar::widgets {

namespace {

const QString keys_format = QStringLiteral("mission-control-keys");
constexpr int newest_keys_version = 1;

tl::unexpected<Error> damagedKeys(const QString& why, const QString& where) {
    return failure("these keys cannot be read: " + why.toStdString(), where.toStdString(),
                   "Correct the file, or delete it to get the usual keys back");
}

bool isReserved(const QKeySequence& key) {
    static const QList<int> reserved{Qt::Key_Escape, Qt::Key_Tab,       Qt::Key_Backtab,
                                     Qt::Key_Return, Qt::Key_Backspace, Qt::Key_Enter};
    return key.count() == 1 && reserved.contains(key[0].key()) &&
           !(key[0].keyboardModifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier));
}

} // namespace

QByteArray keysText(const KeyChoices& keys) {
    QJsonObject commands;
    for (const auto& [id, sequences] : keys) {
        QJsonArray texts;
        for (const QKeySequence& sequence : sequences)
            texts.append(sequence.toString(QKeySequence::PortableText));
        commands[id] = texts;
    }
    return QJsonDocument(QJsonObject{{"format", keys_format}, {"version", newest_keys_version}, {"keys", commands}})
        .toJson();
}

Result<KeyChoices> readKeys(const QByteArray& text, const QString& file) {
    QJsonParseError error;
    const QJsonObject json = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        return damagedKeys(error.errorString(),
                           QStringLiteral("%1, line %2").arg(file).arg(text.left(error.offset).count('\n') + 1));
    if (json["format"].toString() != keys_format)
        return damagedKeys(QStringLiteral("this is no file of keys"), file);
    if (json["version"].toInt(newest_keys_version + 1) > newest_keys_version)
        return failure("these keys were written by a newer version of the program", file.toStdString(),
                       "Use that version, or delete the file to get the usual keys back");
    KeyChoices keys;
    const QJsonObject commands = json["keys"].toObject();
    for (auto command = commands.begin(); command != commands.end(); ++command) {
        QList<QKeySequence>& sequences = keys[command.key()];
        for (const auto& one : command->toArray()) {
            const QKeySequence sequence(one.toString(), QKeySequence::PortableText);
            if (sequence.isEmpty() || sequence[0].key() == Qt::Key_unknown)
                return damagedKeys(QStringLiteral("'%1' is no key").arg(one.toString()),
                                   QStringLiteral("%1, %2").arg(file, command.key()));
            sequences << sequence;
        }
    }
    return keys;
}

KeyVerdict judgeKey(const CommandRegistry& registry, const QString& id, const QKeySequence& key) {
    const QString name = key.toString(QKeySequence::NativeText);
    if (isReserved(key))
        return {false,
                {},
                QObject::tr("%1 is needed to stop robots or to move in the window. Press another key.").arg(name)};
    const CommandRegistry::Command* const owner = registry.ownerOf(key);
    if (!owner || owner->spec.id == id)
        return {};
    return {true, owner->spec.id,
            QObject::tr("%1 already runs \"%2\" (%3). Press it again to take it from there, or press another key.")
                .arg(name, owner->spec.text, owner->spec.group)};
}

void giveKey(CommandRegistry& registry, const QString& id, const QKeySequence& key) {
    if (const auto* const owner = key.isEmpty() ? nullptr : registry.ownerOf(key); owner && owner->spec.id != id) {
        QList<QKeySequence> rest = owner->spec.shortcuts;
        rest.removeAll(key);
        registry.setKeys(owner->spec.id, rest);
    }
    registry.setKeys(id, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
}

} // namespace usar::widgets
