// The choice of a theme: dark, light, or that of the desktop.
#pragma once

#include "widgets/commands/command_registry.h"
#include "widgets/style/system_theme.h"

namespace usar::widgets {

/// Applies the chosen theme, and while the desktop's is chosen, each that the desktop changes to. GUI thread; must not
/// outlive the registry.
class ThemeChooser : public QObject {
    Q_OBJECT
public:
    explicit ThemeChooser(CommandRegistry& commands) : commands_(commands) {}

    /// Registers the commands that choose a theme. To be called once, before `choose`.
    void registerCommands();
    /// Chooses "dark", "light" or "system", as the settings and the command line name them; anything else is dark.
    void choose(const QString& name);
    /// The choice, for the settings.
    const QString& name() const { return name_; }
    /// What the desktop says.
    SystemTheme& system() { return system_; }

private:
    void apply();

    CommandRegistry& commands_;
    SystemTheme system_;
    QString name_;
};

} // namespace usar::widgets
