// The settings of the window at one moment.
#pragma once

#include <QString>
#include <QVariantMap>

namespace usar::app {

/// What the desks would keep now; only what has changed is written to the disk. A plain value.
class SettingsSheet {
public:
    void setValue(const QString& key, const QVariant& value) { values_[key] = value; }
    /// The entries that `earlier` lacks or that have other values there.
    QVariantMap changedSince(const SettingsSheet& earlier) const {
        QVariantMap changed;
        for (auto entry = values_.begin(); entry != values_.end(); ++entry)
            if (const auto old = earlier.values_.find(entry.key());
                old == earlier.values_.end() || *old != entry.value())
                changed.insert(entry.key(), entry.value());
        return changed;
    }

private:
    QVariantMap values_;
};

} // namespace usar::app
