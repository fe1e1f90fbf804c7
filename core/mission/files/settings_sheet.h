// The settings that the window would keep now, as a plain value.
#pragma once

#include <QSettings>
#include <QVariantMap>

namespace usar::mission {

/// Compared with the sheet that was written last, so that only what has changed is written to the disk.
class SettingsSheet {
public:
    void setValue(const QString& key, const QVariant& value) { values_[key] = value; }
    /// The entries that `earlier` lacks or that have other values there.
    QVariantMap changedSince(const SettingsSheet& earlier) const {
        QVariantMap changed;
        for (auto entry = values_.begin(); entry != values_.end(); ++entry)
            if (!earlier.values_.contains(entry.key()) || earlier.values_[entry.key()] != *entry)
                changed.insert(entry.key(), *entry);
        return changed;
    }

    /// Writes these entries to a file of settings, which may take a moment.
    static void write(const QVariantMap& entries, const QString& file) {
        QSettings settings(file, QSettings::NativeFormat);
        for (auto entry = entries.begin(); entry != entries.end(); ++entry)
            settings.setValue(entry.key(), *entry);
    }

private:
    QVariantMap values_;
};

} // namespace usar::mission
