#include "tests/hands/screen_reader.h"

#include <QDBusArgument>
#include <QDBusMessage>
#include <QDBusMetaType>
#include <QDBusObjectPath>
#include <QDBusPendingCall>
#include <QDBusVariant>
#include <QTest>

namespace usar::hands {

/// A reference to an accessible object, as AT-SPI writes it.
struct Reference {
    QString service;
    QDBusObjectPath path;
};

QDBusArgument& operator<<(QDBusArgument& out, const Reference& reference) {
    out.beginStructure();
    out << reference.service << reference.path;
    out.endStructure();
    return out;
}

const QDBusArgument& operator>>(const QDBusArgument& in, Reference& reference) {
    in.beginStructure();
    in >> reference.service >> reference.path;
    in.endStructure();
    return in;
}

namespace {

const QString accessible = QStringLiteral("org.a11y.atspi.Accessible");
const Seen all_programs{"org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root", {}, {}, {}, {}};
constexpr int answer_ms = 5000;

QDBusPendingCall ask(const QDBusConnection& bus, const QString& service, const QString& path, const QString& interface,
                     const QString& method, const QVariantList& arguments = {}) {
    QDBusMessage message = QDBusMessage::createMethodCall(service, path, interface, method);
    message.setArguments(arguments);
    return bus.asyncCall(message, answer_ms);
}

QDBusPendingCall askFor(const QDBusConnection& bus, const Reference& one, const QString& property) {
    return ask(bus, one.service, one.path.path(), "org.freedesktop.DBus.Properties", "Get", {accessible, property});
}

/// Waits for the answer; invalid if there is none, as from a widget that is gone.
QVariant answerOf(QDBusPendingCall asked) {
    asked.waitForFinished();
    const QDBusMessage answer = asked.reply();
    return answer.type() == QDBusMessage::ReplyMessage ? answer.arguments().value(0) : QVariant();
}

QString textOf(const QDBusPendingCall& asked) {
    return qvariant_cast<QDBusVariant>(answerOf(asked)).variant().toString();
}

/// What was asked about one widget. All widgets of a parent are asked at once, because each answer takes a turn of both
/// programs.
struct Asked {
    Asked(const QDBusConnection& bus, const Reference& one)
        : reference(one)
        , role(ask(bus, one.service, one.path.path(), accessible, "GetRoleName"))
        , name(askFor(bus, one, "Name"))
        , description(askFor(bus, one, "Description"))
        , states(ask(bus, one.service, one.path.path(), accessible, "GetState"))
        , extents(ask(bus, one.service, one.path.path(), "org.a11y.atspi.Component", "GetExtents",
                      {QVariant::fromValue<uint>(0)})) {}

    Seen seen() const;

    Reference reference;
    QDBusPendingCall role;
    QDBusPendingCall name;
    QDBusPendingCall description;
    QDBusPendingCall states;
    QDBusPendingCall extents;
};

Seen Asked::seen() const {
    Seen seen{reference.service, reference.path.path(), answerOf(role).toString(),
              textOf(name),      textOf(description),   {}};
    if (const QVariant box = answerOf(extents); box.isValid()) {
        const auto numbers = box.value<QDBusArgument>();
        int x = 0, y = 0, width = 0, height = 0;
        numbers.beginStructure();
        numbers >> x >> y >> width >> height;
        numbers.endStructure();
        seen.at = QRect(x, y, width, height);
    }
    if (const QVariant bits = answerOf(states); bits.isValid()) {
        QList<uint> words;
        bits.value<QDBusArgument>() >> words;
        seen.states = words.value(0) | quint64(words.value(1)) << 32;
    }
    return seen;
}

QString plain(QString words) {
    return words.remove('&').toLower();
}

} // namespace

ScreenReader::ScreenReader(const QDBusConnection& bus, const QSize& screen_px) : bus_(bus), screen_px_({}, screen_px) {
    qDBusRegisterMetaType<Reference>();
    qDBusRegisterMetaType<QList<Reference>>();
}

/// All children; of a table or tree, which has its hidden rows, too, those cells that are likely to be on the screen.
static QList<Reference> childrenOf(const QDBusConnection& bus, const Seen& parent) {
    constexpr int most_cells = 60;
    const auto count = [&] {
        const auto answer = answerOf(askFor(bus, {parent.service, QDBusObjectPath(parent.path)}, "ChildCount"));
        return qvariant_cast<QDBusVariant>(answer).variant().toInt();
    };
    const bool has_rows = parent.role == "table" || parent.role == "tree";
    if (const int all = has_rows ? count() : 0; all > most_cells) {
        const int first = parent.role == "table" ? all - most_cells : 0; // Tables follow their newest rows here.
        std::vector<QDBusPendingCall> asked;
        for (int i = first; i < first + most_cells; ++i)
            asked.push_back(ask(bus, parent.service, parent.path, accessible, "GetChildAtIndex", {i}));
        QList<Reference> children;
        for (const QDBusPendingCall& child : asked)
            if (const QVariant answer = answerOf(child); answer.isValid())
                children << qdbus_cast<Reference>(answer);
        return children;
    }
    const QVariant answer = answerOf(ask(bus, parent.service, parent.path, accessible, "GetChildren"));
    return answer.isValid() ? qdbus_cast<QList<Reference>>(answer) : QList<Reference>();
}

bool ScreenReader::walk(const Seen& parent, const Wanted& visit) const {
    std::vector<Asked> asked;
    for (const Reference& child : childrenOf(bus_, parent))
        asked.emplace_back(bus_, child);
    for (const Asked& child : asked) {
        const Seen seen = child.seen();
        const bool is_program = seen.role == "application";
        if (!is_program && !(seen.showing() && seen.at.intersects(screen_px_)))
            continue; // Neither is anything in it.
        if (!is_program && visit(seen))
            return true;
        if (walk(seen, visit))
            return true;
    }
    return false;
}

std::optional<Seen> ScreenReader::find(const Wanted& wanted, int within_ms) const {
    std::optional<Seen> found;
    const bool came = QTest::qWaitFor(
        [&] {
            return walk(all_programs, [&](const Seen& seen) {
                if (!wanted(seen))
                    return false;
                found = seen;
                return true;
            });
        },
        within_ms);
    return came ? found : std::nullopt;
}

std::optional<Seen> ScreenReader::find(const QString& role, const QString& name, int within_ms) const {
    return find([&](const Seen& seen) { return seen.role == role && plain(seen.name).contains(plain(name)); },
                within_ms);
}

std::vector<Seen> ScreenReader::all(const Wanted& wanted) const {
    std::vector<Seen> found;
    walk(all_programs, [&](const Seen& seen) {
        if (wanted(seen))
            found.push_back(seen);
        return false;
    });
    return found;
}

QString ScreenReader::textOf(const Seen& field) const {
    return answerOf(ask(bus_, field.service, field.path, "org.a11y.atspi.Text", "GetText", {0, -1})).toString();
}

} // namespace usar::hands

Q_DECLARE_METATYPE(usar::hands::Reference)
