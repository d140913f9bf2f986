#include "render/read_radiance.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace hariko {

namespace {

constexpr std::size_t most_header_bytes = 1 << 16;
constexpr int least_run_width = 8, most_run_width = 32767;  // widths of rows in the newer encoding

using Rgbe = std::array<std::uint8_t, 4>;

Message damaged_radiance(const std::string& why) {
  return make_error(e_image_read, "The picture is a damaged Radiance file: " + why + ".",
                    "Save it again with a program for pictures.");
}

Message foreign_radiance(const std::string& why) {
  return make_error(e_image_read, "The Radiance picture cannot be read: " + why + ".",
                    "Save it with red, green and blue, and rows from the top.");
}

struct RadianceHeader {
  PixelSize size;
  double factor = 1;      ///< factor on all values
  std::size_t begin = 0;  ///< beginning of the rows in the file
};

/// Takes the next line off a text, without its end; nothing where it has none.
std::optional<std::string_view> take_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Value behind a header's name, without spaces round it; nothing for other names.
std::optional<std::string_view> header_value(std::string_view line, std::string_view name) {
  if (!line.starts_with(name)) return std::nullopt;
  line.remove_prefix(name.size());
  while (line.starts_with(' ') || line.starts_with('\t')) line.remove_prefix(1);
  while (line.ends_with(' ') || line.ends_with('\t')) line.remove_suffix(1);
  return line;
}

template <class Number>
std::optional<Number> header_number(std::string_view text) {
  Number value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Size out of "-Y 512 +X 1024".
Result<PixelSize> resolution_of(std::string_view line) {
  std::array<std::string_view, 4> words;
  std::size_t count = 0;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0 && count == words.size()) return damaged_radiance("its line of sizes is too long");
    if (end > 0) words[count++] = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  const auto axis = [](std::string_view word) {
    return word.size() == 2 && (word[0] == '-' || word[0] == '+') && (word[1] == 'X' || word[1] == 'Y');
  };
  if (count != words.size() || !axis(words[0]) || !axis(words[2]) || words[0][1] == words[2][1])
    return damaged_radiance("it does not say its size");
  if (words[0] != "-Y" || words[2] != "+X")
    return foreign_radiance("its rows do not run from the top and left");
  const auto height = header_number<int>(words[1]), width = header_number<int>(words[3]);
  if (!height || !width || *height < 1 || *width < 1) return damaged_radiance("its size is no size");
  if (std::max(*width, *height) > most_radiance_side ||
      std::uint64_t(*width) * std::uint64_t(*height) > most_radiance_pixels)
    return make_error(e_image_read, "The picture has more than 150 million pixels, or sides above 65536.",
                      "Make it smaller with a program for pictures.");
  return PixelSize{*width, *height};
}

Result<RadianceHeader> radiance_header(std::string_view file) {
  if (!looks_like_radiance(file)) return damaged_radiance("it does not begin with #?");
  std::string_view rest = file.substr(0, most_header_bytes);
  const std::size_t seen = rest.size();
  RadianceHeader header;
  for (;;) {
    const auto line = take_line(rest);
    if (!line) return damaged_radiance("its header has no end");
    if (line->empty()) break;
    if (const auto format = header_value(*line, "FORMAT="); format && *format != "32-bit_rle_rgbe")
      return foreign_radiance("its colours are not red, green and blue with an exponent");
    if (const auto exposure = header_value(*line, "EXPOSURE=")) {
      const auto value = header_number<double>(*exposure);
      if (!value || !(*value > 0) || !std::isfinite(*value))
        return damaged_radiance("its exposure is no positive number");
      header.factor /= *value;
    }
  }
  const auto line = take_line(rest);
  if (!line) return damaged_radiance("it does not say its size");
  const auto size = resolution_of(*line);
  if (!size) return size.error();
  if (!(header.factor > 0) || !std::isfinite(header.factor))
    return damaged_radiance("its exposures have no finite product");
  header.size = *size;
  header.begin = seen - rest.size();
  return header;
}

/// Reader of the rows' bytes: each function fails where the bytes end or make no row.
class RadianceBytes {
 public:
  explicit RadianceBytes(std::string_view bytes) : rest_(bytes) {}

  /// Reads a row; a sentence's end where it is damaged, null else.
  const char* read_row(std::span<Rgbe> row) {
    const int width = static_cast<int>(row.size());
    const bool may_have_runs = width >= least_run_width && width <= most_run_width;
    if (may_have_runs && rest_.size() >= 4 && byte_at(0) == 2 && byte_at(1) == 2 && byte_at(2) < 128) {
      if (byte_at(2) * 256 + byte_at(3) != width) return "a row has another length than the picture";
      rest_.remove_prefix(4);
      for (std::size_t channel = 0; channel < 4; ++channel)
        if (const char* why = read_channel(row, channel)) return why;
      return nullptr;
    }
    return read_pixels(row);
  }

 private:
  int byte_at(std::size_t index) const { return static_cast<std::uint8_t>(rest_[index]); }

  /// One channel of a row in the newer encoding: runs of one value, and values as they are.
  const char* read_channel(std::span<Rgbe> row, std::size_t channel) {
    std::size_t x = 0;
    while (x < row.size()) {
      if (rest_.empty()) return "rows are missing";
      const int code = byte_at(0);
      const bool run = code > 128;
      const auto count = static_cast<std::size_t>(run ? code - 128 : code);
      if (count == 0 || count > row.size() - x) return "a run is longer than its row";
      if (rest_.size() < 1 + (run ? 1 : count)) return "rows are missing";
      for (std::size_t i = 0; i < count; ++i)
        row[x + i][channel] = static_cast<std::uint8_t>(rest_[1 + (run ? 0 : i)]);
      rest_.remove_prefix(1 + (run ? 1 : count));
      x += count;
    }
    return nullptr;
  }

  /// A flat row, or one in the older encoding, where the pixel 1, 1, 1, n repeats the last one n times;
  /// further such pixels count 256 times as much each.
  const char* read_pixels(std::span<Rgbe> row) {
    std::size_t x = 0;
    unsigned shift = 0;
    while (x < row.size()) {
      if (rest_.size() < 4) return "rows are missing";
      Rgbe pixel;
      for (std::size_t i = 0; i < 4; ++i) pixel[i] = static_cast<std::uint8_t>(rest_[i]);
      rest_.remove_prefix(4);
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        row[x++] = pixel;
        shift = 0;
        continue;
      }
      if (x == 0) return "a row begins with a repetition";
      if (shift > 24) return "a run is longer than its row";
      const std::uint64_t count = std::uint64_t(pixel[3]) << shift;
      if (count > row.size() - x) return "a run is longer than its row";
      for (std::uint64_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
      shift += 8;
    }
    return nullptr;
  }

  std::string_view rest_;
};

Radiance radiance_of(const Rgbe& pixel, double factor) {
  if (pixel[3] == 0) return {0, 0, 0};
  // Mantissas stand for the middle of their interval
  const double scale = std::ldexp(factor, int(pixel[3]) - (128 + 8));
  Radiance out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = static_cast<float>(std::min((double(pixel[c]) + 0.5) * scale, 1e30));
  return out;
}

}  // namespace

bool looks_like_radiance(std::string_view file) {
  return file.starts_with("#?");
}

Result<PixelSize> radiance_size(std::string_view file) {
  const auto header = radiance_header(file);
  if (!header) return header.error();
  return header->size;
}

Result<PixelSize> read_radiance(std::string_view file, const RadianceRows& take) {
  const auto header = radiance_header(file);
  if (!header) return header.error();
  const auto width = static_cast<std::size_t>(header->size.width);
  RadianceBytes bytes(file.substr(header->begin));
  std::vector<Rgbe> row(width);
  std::vector<Radiance> pixels(width);
  for (int y = 0; y < header->size.height; ++y) {
    if (const char* why = bytes.read_row(row)) return damaged_radiance(why);
    for (std::size_t x = 0; x < width; ++x) pixels[x] = radiance_of(row[x], header->factor);
    take(y, pixels);
  }
  return header->size;
}

}  // namespace hariko
