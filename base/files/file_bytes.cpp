// SPDX-License-Identifier: MIT
#include "base/files/file_bytes.h"

#include "base/files/reason_of.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace polhode {

Result<std::vector<std::uint8_t>> read_file_bytes(const std::filesystem::path& path, std::uintmax_t most) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) return failure(error.message());
  if (!std::filesystem::is_regular_file(status)) return failure("it is not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return failure(error.message());
  if (size > most) return failure("it is larger than it can be");
  std::vector<std::uint8_t> bytes(size);
  std::ifstream file(path, std::ios::binary);
  if (!file) return failure(reason_of(errno));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) return failure("it cannot be read to its end");
  return bytes;
}

}  // namespace polhode
