#include "tests/hands/screen_reader.h"

#include <QDBusArgument>
#include <QDBusMessage>
#include <QDBusMetaType>
#include <QDBusObjectPath>
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

QVariant call(const QDBusConnection& bus, const QString& service, const QString& path, const QString& interface,
              const QString& method, const QVariantList& arguments = {}) {
    QDBusMessage message = QDBusMessage::createMethodCall(service, path, interface, method);
    message.setArguments(arguments);
    const QDBusMessage answer = bus.call(message, QDBus::Block, 5000);
    return answer.type() == QDBusMessage::ReplyMessage ? answer.arguments().value(0) : QVariant();
}

QString property(const QDBusConnection& bus, const QString& service, const QString& path, const QString& name) {
    const QVariant value = call(bus, service, path, "org.freedesktop.DBus.Properties", "Get", {accessible, name});
    return qvariant_cast<QDBusVariant>(value).variant().toString();
}

QString plain(QString words) {
    return words.remove('&').toLower();
}

} // namespace

ScreenReader::ScreenReader(const QDBusConnection& bus) : bus_(bus) {
    qDBusRegisterMetaType<Reference>();
    qDBusRegisterMetaType<QList<Reference>>();
}

Seen ScreenReader::look(const QString& service, const QString& path) const {
    Seen seen{service,
              path,
              call(bus_, service, path, accessible, "GetRoleName").toString(),
              property(bus_, service, path, "Name"),
              property(bus_, service, path, "Description"),
              {}};
    const QVariant extents =
        call(bus_, service, path, "org.a11y.atspi.Component", "GetExtents", {QVariant::fromValue<uint>(0)});
    if (extents.isValid()) {
        const auto box = extents.value<QDBusArgument>();
        int x = 0, y = 0, width = 0, height = 0;
        box.beginStructure();
        box >> x >> y >> width >> height;
        box.endStructure();
        seen.at = QRect(x, y, width, height);
    }
    const QVariant states = call(bus_, service, path, accessible, "GetState");
    if (states.isValid()) {
        QList<uint> words;
        states.value<QDBusArgument>() >> words;
        seen.states = words.value(0) | quint64(words.value(1)) << 32;
    }
    return seen;
}

bool ScreenReader::walk(const QString& service, const QString& path,
                        const std::function<bool(const Seen&)>& visit) const {
    const QVariant answer = call(bus_, service, path, accessible, "GetChildren");
    if (!answer.isValid())
        return false;
    QList<Reference> children;
    answer.value<QDBusArgument>() >> children;
    for (const Reference& child : children) {
        const Seen seen = look(child.service, child.path.path());
        const bool is_program = seen.role == "application";
        if (!is_program && !seen.showing())
            continue; // Neither is anything in it.
        if (!is_program && visit(seen))
            return true;
        if (walk(child.service, child.path.path(), visit))
            return true;
    }
    return false;
}

std::optional<Seen> ScreenReader::find(const Wanted& wanted, int within_ms) const {
    std::optional<Seen> found;
    const bool came = QTest::qWaitFor(
        [&] {
            return walk("org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root", [&](const Seen& seen) {
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
    walk("org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root", [&](const Seen& seen) {
        if (wanted(seen))
            found.push_back(seen);
        return false;
    });
    return found;
}

QString ScreenReader::textOf(const Seen& field) const {
    return call(bus_, field.service, field.path, "org.a11y.atspi.Text", "GetText", {0, -1}).toString();
}

} // namespace usar::hands

Q_DECLARE_METATYPE(usar::hands::Reference)
