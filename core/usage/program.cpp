#include "core/usage/program.h"

namespace usar::usage {

QCommandLineOption helpOption() {
    return {{"h", "help"}, "print this help"};
}

QCommandLineOption versionOption() {
    return {{"v", "version"}, "print the version"};
}

QString spelled(const QString& name) {
    return (name.size() == 1 ? "-" : "--") + name;
}

QString spelled(const QCommandLineOption& option) {
    QStringList names;
    for (const QString& name : option.names())
        names << spelled(name);
    return names.join(", ") + (option.valueName().isEmpty() ? QString() : ' ' + option.valueName());
}

QString meaningOf(const QCommandLineOption& option) {
    const QString usual = option.defaultValues().join(' ');
    return option.description() + (usual.isEmpty() ? QString() : " (" + usual + ')');
}

} // namespace usar::usage
