#include "widgets/commands/theme_chooser.h"

namespace usar::widgets {

namespace {

const QString dark_name = QStringLiteral("dark");
const QString light_name = QStringLiteral("light");
const QString system_name = QStringLiteral("system");

QString nameOf(Theme theme) {
    return theme == Theme::Light ? light_name : dark_name;
}

} // namespace

void ThemeChooser::registerCommands() {
    commands_.add(commandSpec("view.dark"), [this](bool dark) { choose(dark ? dark_name : light_name); });
    commands_.add(commandSpec("view.system_theme"),
                  [this](bool on) { choose(on ? system_name : nameOf(currentTheme())); });
    connect(&system_, &SystemTheme::changed, this, &ThemeChooser::apply);
}

void ThemeChooser::choose(const QString& name) {
    name_ = name == light_name || name == system_name ? name : dark_name;
    if (name_ == system_name)
        system_.follow();
    apply();
}

void ThemeChooser::apply() {
    const Theme theme = name_ == system_name ? system_.theme() : name_ == light_name ? Theme::Light : Theme::Dark;
    applyTheme(theme);
    commands_.action("view.dark")->setChecked(theme == Theme::Dark);
    commands_.action("view.system_theme")->setChecked(name_ == system_name);
}

} // namespace usar::widgets
